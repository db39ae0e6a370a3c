// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace spherewalk::render {

/// Zeroed memory for SIMD, aligned to cache lines. Large buffers ask for huge pages. A photo's rows lie far
/// apart: a view that reads a thousand of them would otherwise miss the processor's page table cache for
/// each. Errors: std::bad_alloc.
template <class Value>
class AlignedBuffer {
  public:
    AlignedBuffer() = default;

    explicit AlignedBuffer(std::size_t count) : m_values(allocated(count)), m_size(count) {}

    std::size_t size() const { return m_size; }

    Value* data() { return m_values.get(); }

    const Value* data() const { return m_values.get(); }

    Value& operator[](std::size_t i) { return m_values[i]; }

    const Value& operator[](std::size_t i) const { return m_values[i]; }

  private:
    struct Release {
        void operator()(Value* values) const { std::free(values); }
    };

    static Value* allocated(std::size_t count) {
        constexpr std::size_t kHugePage = std::size_t{2} << 20;
        const std::size_t bytes = count * sizeof(Value);
        const std::size_t alignment = bytes >= 2 * kHugePage ? kHugePage : 64;
        const std::size_t padded = (bytes + alignment - 1) / alignment * alignment;
        void* memory = std::aligned_alloc(alignment, padded == 0 ? alignment : padded);
        if (memory == nullptr) {
            throw std::bad_alloc();
        }
#if defined(__linux__)
        if (alignment == kHugePage) {
            ::madvise(memory, padded, MADV_HUGEPAGE); // a wish: nothing depends on its being granted
        }
#endif
        std::memset(memory, 0, padded);
        return static_cast<Value*>(memory);
    }

    std::unique_ptr<Value[], Release> m_values;
    std::size_t m_size = 0;
};

} // namespace spherewalk::render
