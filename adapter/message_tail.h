// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "adapter/file_descriptor.h"

namespace povpreview {

/// The end of what a child writes to a pipe: its last words, not its statistics, however much it
/// says.
class MessageTail {
   public:
    MessageTail() = default;
    /// `pipe` is the end to read from; it never waits (O_NONBLOCK).
    explicit MessageTail(FileDescriptor pipe) : pipe_(std::move(pipe)) {}

    /// To be waited on for more; -1 when the other end is closed.
    int descriptor() const { return pipe_.get(); }
    /// Takes in what has come. A full pipe would stop the child: call it often.
    void drain();
    void close() { pipe_.reset(); }
    /// The last 16 KiB or more, or all.
    const std::string& text() const { return text_; }
    /// The last lines of it that are not empty, without what a status line overwrote.
    std::string last_lines(std::size_t count) const;

   private:
    FileDescriptor pipe_;
    std::string text_;
};

}  // namespace povpreview
