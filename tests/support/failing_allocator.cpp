// SPDX-License-Identifier: MIT
#include "failing_allocator.h"

#include <algorithm>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace support {

namespace {

constexpr long kNoLimit = -1;
thread_local long allocationsLeft = kNoLimit;
thread_local long blocks = 0;
thread_local long bytes = 0;
thread_local long peak = 0;
thread_local long bytesAtRestart = 0;

void *allocate(std::size_t size) noexcept {
    if (allocationsLeft == 0) return nullptr;
    if (allocationsLeft > 0) --allocationsLeft;
    void *block = std::malloc(size ? size : 1);
    if (!block) return nullptr;
    ++blocks;
    bytes += static_cast<long>(malloc_usable_size(block));
    peak = std::max(peak, bytes);
    return block;
}

void release(void *block) noexcept {
    if (!block) return;
    --blocks;
    bytes -= static_cast<long>(malloc_usable_size(block));
    std::free(block);
}

} // namespace

AllocationsLeft::AllocationsLeft(long count) { allocationsLeft = count; }
AllocationsLeft::~AllocationsLeft() { allocationsLeft = kNoLimit; }

long liveBlocks() { return blocks; }

long peakBytes() { return peak - bytesAtRestart; }

void restartPeak() { peak = bytesAtRestart = bytes; }

} // namespace support

void *operator new(std::size_t size) {
    if (void *block = support::allocate(size)) return block;
    throw std::bad_alloc();
}
void *operator new[](std::size_t size) { return operator new(size); }
void *operator new(std::size_t size, const std::nothrow_t &) noexcept { return support::allocate(size); }
void *operator new[](std::size_t size, const std::nothrow_t &) noexcept { return support::allocate(size); }
void operator delete(void *block) noexcept { support::release(block); }
void operator delete[](void *block) noexcept { support::release(block); }
void operator delete(void *block, std::size_t) noexcept { support::release(block); }
void operator delete[](void *block, std::size_t) noexcept { support::release(block); }
