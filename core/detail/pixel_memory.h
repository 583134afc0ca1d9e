// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace povpreview {

/// A value for each pixel, of no certain value at first. Memory comes into being where it is first
/// written to, so that threads can share that work, and in large pages where the system has them:
/// a picture's worth of small ones takes as long as drawing a simple scene.
template <class T>
class PixelMemory {
   public:
    static_assert(std::is_trivially_copyable_v<T>);

    /// Throws std::bad_alloc.
    explicit PixelMemory(std::size_t pixels) {
        constexpr std::size_t large_page = std::size_t{1} << 21;
        const std::size_t bytes = (pixels * sizeof(T) + large_page - 1) / large_page * large_page;
        values_.reset(static_cast<T*>(std::aligned_alloc(large_page, bytes)));
        if (!values_) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
        madvise(values_.get(), bytes, MADV_HUGEPAGE);  // a wish; what comes of it does not matter
#endif
    }

    T& operator[](std::size_t pixel) { return values_[pixel]; }
    const T& operator[](std::size_t pixel) const { return values_[pixel]; }

   private:
    struct Free {
        void operator()(T* values) const { std::free(values); }
    };
    std::unique_ptr<T[], Free> values_;
};

}  // namespace povpreview
