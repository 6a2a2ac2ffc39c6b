// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sample_ring.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace inspector {

namespace {

constexpr size_t kTimeWord = offsetof(Sample, time) / sizeof(uint64_t);
constexpr size_t kFirstChannelWord = offsetof(Sample, values) / sizeof(uint64_t);

/// The smallest power of two, s, with which at most `columns` columns cover the times.
double columnWidth(double from, double to, size_t columns) {
    constexpr double kLeast = 1e-12; // s; the times may be equal
    double width = std::scalbn(1.0, std::ilogb(std::max(to - from, kLeast) / double(columns)));
    while (std::floor(to / width) - std::floor(from / width) + 1.0 > double(columns)) width *= 2.0;
    return width;
}

} // namespace

SampleRing::SampleRing(size_t capacity)
    : m_samples(std::max(capacity, kFan * kFan)) {
    for (uint64_t span = kFan; span <= m_samples.capacity(); span *= kFan) {
        const size_t nodes = m_samples.capacity() / span;
        m_levels.push_back({span, nodes, SharedWords(nodes * kChannelCount * 2)});
    }
}

/// The nodes that this sample completes are written before it becomes visible.
void SampleRing::append(const Sample &sample) {
    m_samples.write(sample);
    closeNodes(m_samples.written());
    m_samples.publish();
}

/// Writes the nodes completed by the last sample, bottom up.
void SampleRing::closeNodes(uint64_t count) {
    for (Level &level : m_levels) {
        if (count % level.span != 0) return;
        const uint64_t begin = count - level.span;
        for (size_t channel = 0; channel < kChannelCount; ++channel) {
            const Extremes found = extremesBelow(level.span, channel, begin, count);
            const size_t place = level.place(begin, channel);
            level.extremes.store(place, std::bit_cast<uint64_t>(found.min));
            level.extremes.store(place + 1, std::bit_cast<uint64_t>(found.max));
        }
    }
}

double SampleRing::timeOf(uint64_t number) const { return std::bit_cast<double>(m_samples.word(number, kTimeWord)); }

double SampleRing::valueOf(uint64_t number, size_t channel) const {
    return std::bit_cast<double>(m_samples.word(number, kFirstChannelWord + channel));
}

uint64_t SampleRing::find(double time) const {
    const uint64_t begin = first();
    return find(time, begin, std::max(begin, last()));
}

/// The first at or after `time` in [begin, end); end if there is none.
uint64_t SampleRing::find(double time, uint64_t begin, uint64_t end) const {
    while (begin < end) {
        const uint64_t middle = begin + (end - begin) / 2;
        if (timeOf(middle) < time)
            begin = middle + 1;
        else
            end = middle;
    }
    return begin;
}

/// The extremes over samples [begin, end), taken from nodes whose span is less than `limit` where they fit and from
/// single samples elsewhere.
SampleRing::Extremes SampleRing::extremesBelow(uint64_t limit, size_t channel, uint64_t begin, uint64_t end) const {
    const double start = valueOf(begin, channel);
    Extremes result{start, start};
    while (begin < end) {
        const Level *widest = nullptr;
        for (const Level &level : m_levels)
            if (level.span < limit && begin % level.span == 0 && begin + level.span <= end) widest = &level;
        Extremes part;
        if (widest) {
            const size_t place = widest->place(begin, channel);
            part = {std::bit_cast<double>(widest->extremes.load(place)),
                    std::bit_cast<double>(widest->extremes.load(place + 1))};
        } else {
            const double value = valueOf(begin, channel);
            part = {value, value};
        }
        result = {std::fmin(result.min, part.min), std::fmax(result.max, part.max)}; // fmin and fmax ignore a NaN
        begin += widest ? widest->span : 1;
    }
    return result;
}

std::vector<Column> SampleRing::columns(Channel channel, double from, double to, size_t columns) const {
    const uint64_t oldest = first();
    const uint64_t newest = last();
    const uint64_t found = find(from);
    const uint64_t begin = found > oldest ? found - 1 : oldest;
    const uint64_t end = std::min(newest, find(to) + 1);
    if (begin >= end || columns == 0) return {};

    // By time, because steps differ in length. Column widths are powers of two and columns start at multiples of it, so
    // that they don't flicker while the plot scrolls.
    const double width = end - begin <= columns ? 0.0 : columnWidth(timeOf(begin), timeOf(end - 1), columns);
    std::vector<Column> result;
    for (uint64_t i = begin; i < end;) {
        const double time = timeOf(i);
        const double next = width > 0.0 ? (std::floor(time / width) + 1.0) * width : time;
        const uint64_t stop = std::max(i + 1, find(next, i, end));
        const Extremes extremes = extremesBelow(UINT64_MAX, size_t(channel), i, stop);
        if (i >= first()) result.push_back({time, extremes.min, extremes.max});
        i = stop;
    }
    return result;
}

std::vector<Sample> SampleRing::spread(uint64_t begin, uint64_t end, size_t intervals) const {
    std::vector<Sample> result;
    if (begin >= end) return result;
    const double interval = (timeOf(end - 1) - timeOf(begin)) / double(intervals);
    Sample sample;
    for (uint64_t i = begin; i < end; i = std::max(i + 1, find(timeOf(i) + interval, i, end)))
        if (read(i, sample)) result.push_back(sample);
    return result;
}

} // namespace inspector
