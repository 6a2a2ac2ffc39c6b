// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of the last steps, with a pyramid of extremes (like mipmaps), so that the cost of a plot depends on its
// pixels, not on the number of samples.
#pragma once

#include "core/engine/sample.h"
#include "core/engine/slot_ring.h"

#include <vector>

namespace inspector {

/// Minimum and maximum of a channel over the samples of one column of a plot; NaN if none of them has a value.
struct Column {
    double time = 0.0; ///< of its first sample, s
    double min = 0.0;
    double max = 0.0;
};

/// One thread appends while any others read (see SlotRing).
class SampleRing {
public:
    /// 8.7 minutes at 1 ms; memory grows with the samples, to some 200 MB.
    static constexpr size_t kDefaultCapacity = size_t(1) << 19;

    /// capacity: rounded up to a power of two, at least 256.
    explicit SampleRing(size_t capacity = kDefaultCapacity);

    /// Writer only. Times must not decrease between two clear().
    void append(const Sample &sample);
    void clear() { m_samples.clear(); }
    void truncate(uint64_t number) { m_samples.truncate(number); }
    void hold() { m_samples.hold(); }
    void release() { m_samples.release(); }

    /// For readers: samples [first(), last()) can be read at this moment.
    size_t capacity() const { return m_samples.capacity(); }
    uint64_t first() const { return m_samples.first(); }
    uint64_t last() const { return m_samples.last(); }
    /// Whether samples since the last clear() were overwritten; first() doesn't tell, as numbers never restart.
    bool hasLostSamples() const { return first() > m_samples.firstOfGeneration(); }
    uint64_t generation() const { return m_samples.generation(); } ///< changes when readers must start over
    bool read(uint64_t number, Sample &out) const { return m_samples.read(number, out); }
    /// Number of the first sample whose time is at least `time`; last() if there is none.
    uint64_t find(double time) const;
    /// At most `columns` extremes of one channel over [from, to] seconds, in order of time. One sample on either side
    /// of the range is included, so that lines reach the plot's border. If the samples are few enough, each is a
    /// column; otherwise columns divide the time evenly, however long steps are, into less than 2 / (columns - 1) of
    /// the range each. Costs O(columns log capacity).
    std::vector<Column> columns(Channel channel, double from, double to, size_t columns) const;
    /// At most `intervals` + 1 of the samples [begin, end), evenly spaced in time if steps are short enough.
    std::vector<Sample> spread(uint64_t begin, uint64_t end, size_t intervals) const;

private:
    static constexpr size_t kFan = 16; ///< children of a node of the pyramid

    struct Level {
        uint64_t span;        ///< samples under one node
        size_t nodes;         ///< size of this level's ring
        SharedWords extremes; ///< [node][channel][min, max]

        size_t place(uint64_t number, size_t channel) const {
            return (size_t(number / span % nodes) * kChannelCount + channel) * 2;
        }
    };

    struct Extremes {
        double min, max;
    };

    uint64_t find(double time, uint64_t begin, uint64_t end) const;
    double timeOf(uint64_t number) const;
    double valueOf(uint64_t number, size_t channel) const;
    Extremes extremesBelow(uint64_t limit, size_t channel, uint64_t begin, uint64_t end) const;
    void closeNodes(uint64_t count);

    SlotRing<Sample> m_samples;
    std::vector<Level> m_levels;
};

} // namespace inspector
