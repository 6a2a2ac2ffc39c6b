// SPDX-License-Identifier: MIT
// Memory that runs out when a test wants it to. A suite that compiles failing_allocator.cpp uses its operator new
// everywhere, also in the library, because a program's operator new replaces the standard one.
#pragma once

namespace support {

/// While it exists, operator new in this thread succeeds this many times more, and then fails.
class AllocationsLeft {
public:
    explicit AllocationsLeft(long count);
    ~AllocationsLeft();
    AllocationsLeft(const AllocationsLeft &) = delete;
    AllocationsLeft &operator=(const AllocationsLeft &) = delete;
};

/// Blocks that this thread made minus those it freed.
long liveBlocks();

/// The most bytes that this thread held at a time since `restartPeak`, beyond those that it held then.
long peakBytes();
void restartPeak();

} // namespace support
