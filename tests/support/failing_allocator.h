// SPDX-License-Identifier: MIT
// Memory that runs out when a test wants it to. A suite that compiles failing_allocator.cpp in has its operator new
// everywhere, in the library too: a program's replaces the standard one.
#pragma once

namespace support {

/// While it lives, this thread gets so many allocations more by operator new, and then none.
class AllocationsLeft {
public:
    explicit AllocationsLeft(long count);
    ~AllocationsLeft();
    AllocationsLeft(const AllocationsLeft &) = delete;
    AllocationsLeft &operator=(const AllocationsLeft &) = delete;
};

/// Blocks that this thread made minus those it freed.
long liveBlocks();

/// The most bytes that this thread had at once since `restartPeak`, beyond those that it had then.
long peakBytes();
void restartPeak();

} // namespace support
