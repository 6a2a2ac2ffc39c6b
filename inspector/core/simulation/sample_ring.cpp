// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sample_ring.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace inspector {

namespace {

constexpr size_t kTimeCell = 0;
constexpr size_t kStepCell = 1;
constexpr size_t kFirstChannelCell = 2;

// Every cell is stored with release and loaded with acquire: a reader that meets a value of a newer sample then also
// sees that this sample was begun, and knows that the slot isn't whole. On x86 and ARM64 both cost nothing extra.
void store(std::atomic<double> &cell, double value) { cell.store(value, std::memory_order_release); }
double load(const std::atomic<double> &cell) { return cell.load(std::memory_order_acquire); }

} // namespace

SampleRing::SampleRing(size_t capacity)
    : m_capacity(std::bit_ceil(std::max(capacity, kFan * kFan)))
    , m_cells(std::make_unique<Cell[]>(m_capacity * kWidth)) {
    for (uint64_t span = kFan; span <= m_capacity; span *= kFan) {
        const size_t nodes = m_capacity / span;
        m_levels.push_back({span, nodes, std::make_unique<Cell[]>(nodes * kChannelCount * 2)});
    }
}

void SampleRing::append(const Sample &sample) {
    const uint64_t number = m_written;
    m_begun.store(number + 1, std::memory_order_relaxed);
    Cell *cells = &m_cells[(number % m_capacity) * kWidth];
    store(cells[kTimeCell], sample.time);
    store(cells[kStepCell], double(sample.step));
    for (size_t i = 0; i < kChannelCount; ++i) store(cells[kFirstChannelCell + i], sample.values[i]);
    closeNodes(number + 1);
    m_written = number + 1;
    if (!m_isHeld) m_last.store(m_written, std::memory_order_release);
}

// Writes the nodes whose last sample was just appended, from the samples up.
void SampleRing::closeNodes(uint64_t count) {
    for (Level &level : m_levels) {
        if (count % level.span != 0) return;
        const uint64_t begin = count - level.span;
        Cell *extremes = &level.extremes[(begin / level.span) % level.nodes * kChannelCount * 2];
        for (size_t channel = 0; channel < kChannelCount; ++channel) {
            const Extremes found = extremesBelow(level.span, channel, begin, count);
            store(extremes[2 * channel], found.min);
            store(extremes[2 * channel + 1], found.max);
        }
    }
}

void SampleRing::clear() {
    m_wiped = m_written;
    ++m_clears;
    if (!m_isHeld) show();
}

void SampleRing::hold() { m_isHeld = true; }

void SampleRing::release() {
    m_isHeld = false;
    show();
}

// First what is gone, then what is new: samples from before and after a clear() are never seen together.
void SampleRing::show() {
    m_cleared.store(m_wiped, std::memory_order_release);
    m_last.store(m_written, std::memory_order_release);
    m_generation.store(m_clears, std::memory_order_release);
}

uint64_t SampleRing::first() const {
    const uint64_t begun = m_begun.load(std::memory_order_acquire);
    const uint64_t oldest = begun > m_capacity ? begun - m_capacity : 0;
    return std::max(oldest, m_cleared.load(std::memory_order_acquire));
}

bool SampleRing::read(uint64_t number, Sample &out) const {
    if (number < first() || number >= last()) return false;
    const Cell *cells = &m_cells[(number % m_capacity) * kWidth];
    Sample sample;
    sample.time = load(cells[kTimeCell]);
    sample.step = uint64_t(load(cells[kStepCell]));
    for (size_t i = 0; i < kChannelCount; ++i) sample.values[i] = load(cells[kFirstChannelCell + i]);
    if (number < first()) return false;
    out = sample;
    return true;
}

double SampleRing::timeOf(uint64_t number) const { return load(m_cells[(number % m_capacity) * kWidth + kTimeCell]); }

uint64_t SampleRing::find(double time) const {
    uint64_t begin = first();
    uint64_t end = std::max(begin, last());
    while (begin < end) {
        const uint64_t middle = begin + (end - begin) / 2;
        if (timeOf(middle) < time)
            begin = middle + 1;
        else
            end = middle;
    }
    return begin;
}

// Over samples [begin, end), by nodes whose span is less than `limit` where they fit and single samples elsewhere.
SampleRing::Extremes SampleRing::extremesBelow(uint64_t limit, size_t channel, uint64_t begin, uint64_t end) const {
    const double start = load(m_cells[(begin % m_capacity) * kWidth + kFirstChannelCell + channel]);
    Extremes result{start, start};
    while (begin < end) {
        const Level *widest = nullptr;
        for (const Level &level : m_levels)
            if (level.span < limit && begin % level.span == 0 && begin + level.span <= end) widest = &level;
        Extremes part;
        if (widest) {
            const Cell *cells =
                &widest->extremes[((begin / widest->span) % widest->nodes * kChannelCount + channel) * 2];
            part = {load(cells[0]), load(cells[1])};
        } else {
            const double value = load(m_cells[(begin % m_capacity) * kWidth + kFirstChannelCell + channel]);
            part = {value, value};
        }
        result = {std::fmin(result.min, part.min), std::fmax(result.max, part.max)}; // of a number and none: the number
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

    // Columns are a power of two wide and start at its multiples, so that they don't flicker while the plot scrolls.
    uint64_t width = 1;
    while ((end - 1) / width - begin / width + 1 > columns && width < m_capacity) width *= 2;
    std::vector<Column> result;
    for (uint64_t i = begin; i < end; i = (i / width + 1) * width) {
        const uint64_t stop = std::min(end, (i / width + 1) * width);
        const Extremes extremes = extremesBelow(UINT64_MAX, size_t(channel), i, stop);
        const Column column{timeOf(i), extremes.min, extremes.max};
        if (i >= first()) result.push_back(column);
    }
    return result;
}

} // namespace inspector
