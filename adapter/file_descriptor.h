// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace povpreview {

/// Owns a file descriptor.
class FileDescriptor {
   public:
    explicit FileDescriptor(int fd = -1) : fd_(fd) {}
    ~FileDescriptor() { reset(); }
    FileDescriptor(FileDescriptor&& other) noexcept : fd_(other.release()) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        if (this != &other) {
            reset();
            fd_ = other.release();
        }
        return *this;
    }

    int get() const { return fd_; }
    bool open() const { return fd_ >= 0; }
    void reset();

   private:
    int release() {
        const int fd = fd_;
        fd_ = -1;
        return fd;
    }
    int fd_;
};

}  // namespace povpreview
