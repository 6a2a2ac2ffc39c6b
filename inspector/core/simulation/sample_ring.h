// SPDX-License-Identifier: GPL-3.0-or-later
// Every sample of the last steps, with a pyramid of extremes, so that a plot of any zoom costs pixels, not samples.
#pragma once

#include "core/engine/sample.h"

#include <atomic>
#include <memory>
#include <vector>

namespace inspector {

// Extremes of a channel over the samples of one column of a plot; NaN if none of them has a value.
struct Column {
    double time = 0.0; // of its first sample, s
    double min = 0.0;
    double max = 0.0;
};

// One thread appends, any others read at the same time; nobody waits. Samples are numbered from 0 for ever; the
// oldest are overwritten. A read returns only samples that stayed whole while it was reading.
class SampleRing {
public:
    static constexpr size_t kDefaultCapacity = size_t(1) << 17; // 22 minutes at 10 ms

    // capacity: rounded up to a power of two, at least 256.
    explicit SampleRing(size_t capacity = kDefaultCapacity);

    // Writer's side. Times must not fall between two clear().
    void append(const Sample &sample);
    void clear();
    // What is done between the two is seen by nobody before the second, and then all at once.
    void hold();
    void release();

    // Readers' side. Numbers [first(), last()) can be read just now.
    size_t capacity() const { return m_capacity; }
    uint64_t first() const;
    uint64_t last() const { return m_last.load(std::memory_order_acquire); }
    // How often clear() was called: a plot that sees another number starts anew.
    uint64_t generation() const { return m_generation.load(std::memory_order_acquire); }

    // Sample `number`; false if it is gone or not there yet.
    bool read(uint64_t number, Sample &out) const;
    // Number of the first sample whose time is at least `time`; last() if there is none.
    uint64_t find(double time) const;
    // At most `columns` extremes of one channel over [from, to] seconds, in order of time. One sample to the left and
    // right of the range is included, so that lines reach the plot's border. Costs O(columns + log capacity).
    std::vector<Column> columns(Channel channel, double from, double to, size_t columns) const;

private:
    static constexpr size_t kFan = 16;                  // children of a node of the pyramid
    static constexpr size_t kWidth = 2 + kChannelCount; // time, step, channels
    using Cell = std::atomic<double>;

    struct Level {
        uint64_t span;                    // samples under one node
        size_t nodes;                     // ring of so many nodes
        std::unique_ptr<Cell[]> extremes; // [node][channel][min, max]
    };

    struct Extremes {
        double min, max;
    };

    double timeOf(uint64_t number) const;
    Extremes extremesBelow(uint64_t limit, size_t channel, uint64_t begin, uint64_t end) const;
    void closeNodes(uint64_t count);
    void show();

    size_t m_capacity;
    std::unique_ptr<Cell[]> m_cells; // [slot][kWidth]
    std::vector<Level> m_levels;
    // The writer's own: what there is to see once it isn't held back any more.
    uint64_t m_written = 0; // samples appended
    uint64_t m_wiped = 0;   // m_written at the last clear()
    uint64_t m_clears = 0;
    bool m_isHeld = false;
    // What is seen.
    std::atomic<uint64_t> m_last{0};    // as m_written
    std::atomic<uint64_t> m_begun{0};   // m_last, or one more while a sample is being written
    std::atomic<uint64_t> m_cleared{0}; // as m_wiped
    std::atomic<uint64_t> m_generation{0};
};

} // namespace inspector
