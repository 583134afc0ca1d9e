// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace povpreview {

/// How much of a PixelMemory is soon written to: that tells in what pages it had best come.
enum class Touched {
    here_and_there,  ///< small ones
    all_over         ///< large ones where the system has them
};

/// A value for each pixel, with all bits 0 at first. Memory comes into being page by page where it
/// is first touched: threads can share that work, and the first samples do not wait for the memory
/// of all others. A picture's worth of small pages takes as long as drawing a simple scene; a large
/// one takes as long as many samples.
template <class T>
class PixelMemory {
   public:
    static_assert(std::is_trivially_copyable_v<T>);

    /// Throws std::bad_alloc.
    explicit PixelMemory(std::size_t pixels, Touched touched = Touched::here_and_there)
        : size_(pixels) {
        const bool large = touched == Touched::all_over && pixels * sizeof(T) >= large_page / 4;
        const std::size_t used = large ? round_up(pixels * sizeof(T)) : pixels * sizeof(T);
        // A large page's worth more, since large pages begin where not all mappings do.
        mapped_ = map(std::max<std::size_t>(1, used) + (large ? large_page : 0));
        values_ = static_cast<T*>(mapped_.get());
        if (!large) return;
        values_ = reinterpret_cast<T*>(round_up(reinterpret_cast<std::uintptr_t>(values_)));
#ifdef MADV_HUGEPAGE
        madvise(values_, used, MADV_HUGEPAGE);  // a wish; what comes of it does not matter
#endif
    }

    std::size_t size() const { return size_; }
    T& operator[](std::size_t pixel) {
        assert(pixel < size_);
        return values_[pixel];
    }
    const T& operator[](std::size_t pixel) const {
        assert(pixel < size_);
        return values_[pixel];
    }
    std::span<const T> all() const { return {values_, size_}; }

   private:
    static constexpr std::size_t large_page = std::size_t{1} << 21;
    static constexpr std::size_t round_up(std::size_t bytes) {
        return (bytes + large_page - 1) / large_page * large_page;
    }

    struct Unmap {
        std::size_t bytes;
        void operator()(void* at) const { munmap(at, bytes); }
    };
    using Mapped = std::unique_ptr<void, Unmap>;

    /// Memory straight from the system.
    static Mapped map(std::size_t bytes) {
        void* const at =
            mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (at == MAP_FAILED) throw std::bad_alloc();
        return {at, Unmap{bytes}};
    }

    std::size_t size_;
    Mapped mapped_{nullptr, Unmap{0}};
    T* values_;
};

}  // namespace povpreview
