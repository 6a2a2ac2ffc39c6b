// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/history.h"

#include "core/recording/same_bits.h"

#include <algorithm>

namespace inspector {

size_t Past::runIndexAt(uint64_t place) const {
    const std::vector<uint64_t> &runs = recording->runs();
    size_t run = 0;
    size_t after = runs.size();
    while (after - run > 1) {
        const size_t middle = run + (after - run) / 2;
        (beginOf(middle) <= place ? run : after) = middle;
    }
    return run;
}

uint64_t Past::placeOf(uint64_t position, size_t segment) const {
    const std::vector<uint64_t> &runs = recording->runs();
    const auto after = std::upper_bound(runs.begin(), runs.end(), recording->begin(segment));
    return begin + position + uint64_t(after - runs.begin() - 1);
}

uint64_t Past::placeAt(double time, uint64_t place) const {
    const size_t run = runIndexAt(place);
    return beginOf(run) + recording->stepsUntil(time, run);
}

History::History(uint64_t mostSteps)
    : m_mostSteps(mostSteps) {}

void History::setOrigin(const Origin &origin) {
    m_origin = origin;
    m_place.reset();
}

void History::beginRun() {
    if (m_end != m_run) m_run = ++m_end;
}

void History::resumeRun(uint64_t begin) {
    m_run = begin;
    --m_end;
}

bool History::needsBlock(const Engine &engine, bool isRun) const {
    if (isRun || !m_place || m_blocks.empty()) return true;
    const Block &last = m_blocks.back();
    if (last.hashes.size() >= kBlockSteps || last.dt != engine.dt()) return true;
    return last.place != m_place || !isSameBits(last.inputs, engine.inputs());
}

void History::openBlock(const Engine &engine, bool isRun) {
    if (!m_place || m_place->scene != engine.scene())
        m_place = std::make_shared<const Place>(Place{m_origin, engine.scene()});
    if (!m_blocks.empty()) m_blocks.back().hashes.shrink_to_fit();
    m_blocks.push_back(
        {m_end, m_place, engine.dt(), engine.inputs(), engine.previous(), engine.previousSums(), isRun, {}});
}

void History::note(const Engine &engine) {
    const bool isRun = m_end == m_run;
    if (needsBlock(engine, isRun)) openBlock(engine, isRun);
    m_blocks.back().hashes.push_back(phys_state_hash(&engine.state()));
    ++m_end;
    dropOldest();
}

void History::dropOldest() {
    while (m_blocks.size() > 1 && (m_end - m_blocks[1].begin >= m_mostSteps || m_blocks.size() > kMostBlocks))
        m_blocks.pop_front();
}

Segment History::segmentOf(const Block &block, bool isFirst) {
    const Origin &origin = block.place->origin;
    Segment segment;
    segment.conditions = {origin.maze, {origin.stepper.id, origin.stepper.version}, block.dt, block.inputs};
    if (block.isRun || isFirst) segment.from = block.from;
    segment.hashes = block.hashes;
    return segment;
}

/// One entry per maze, with the scene as it was opened last.
void History::addMaze(std::vector<PlayableRecording::Maze> &mazes, const Place &place) {
    const MazeSource &source = place.origin.maze;
    const auto known =
        std::find_if(mazes.begin(), mazes.end(), [&](const auto &maze) { return maze.source == source; });
    if (known != mazes.end())
        known->scene = place.scene;
    else
        mazes.push_back({source, levelOfFile(source.path), place.scene});
}

/// Takes whole blocks except for the last one, so that every place has its keyframe.
std::optional<Past> History::past(uint64_t from, uint64_t to, QString *error) const {
    Recording recording;
    recording.program = QStringLiteral("physics-inspector");
    recording.library = QString::fromUtf8(phys_version());
    recording.isWhole = true;
    Past past;
    std::vector<PlayableRecording::Maze> mazes;
    const Place *place = nullptr;
    uint64_t position = 0;
    for (const Block &block : m_blocks) {
        if (block.begin + block.hashes.size() <= from || block.begin >= to) continue;
        const bool isFirst = recording.segments.empty();
        if (isFirst) past.begin = block.begin;
        recording.segments.push_back(segmentOf(block, isFirst));
        std::vector<uint64_t> &hashes = recording.segments.back().hashes;
        hashes.resize(std::min<uint64_t>(hashes.size(), to - block.begin));
        past.keyframes.push_back({position, recording.segments.size() - 1, block.from, block.sums});
        position += hashes.size();
        if (block.place.get() != place) addMaze(mazes, *block.place);
        place = block.place.get();
    }
    past.recording = PlayableRecording::ofMazes(std::move(recording), m_origin.registry, std::move(mazes), error);
    if (!past.recording) return std::nullopt;
    return past;
}

} // namespace inspector
