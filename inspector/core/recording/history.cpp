// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/history.h"

#include "core/recording/same_bits.h"

#include <algorithm>
#include <cmath>

namespace inspector {

uint64_t Past::beginOfRun(uint64_t place) const { return begin + recording->beginOfRun(place - begin); }

uint64_t Past::endOfRun(uint64_t place) const { return begin + recording->endOfRun(place - begin); }

uint64_t Past::firstOfRun(uint64_t place) const {
    const uint64_t first = beginOfRun(place);
    return first == begin ? first : first + 1;
}

/// Steps at the block's dt from the run's last keyframe at or before this place.
uint64_t Past::placeAt(double time, uint64_t place) const {
    const uint64_t first = beginOfRun(place) - begin;
    const uint64_t last = endOfRun(place) - begin;
    const Keyframe *before = nullptr;
    for (const Keyframe &keyframe : keyframes) {
        if (keyframe.position < first || keyframe.position >= last) continue;
        if (before && keyframe.state.time > time) break;
        before = &keyframe;
    }
    if (!before) return firstOfRun(place);
    const double dt = recording->segment(before->segment).conditions.dt;
    const double steps = std::ceil((time - before->state.time) / dt - 1e-6);
    return std::clamp(begin + before->position + uint64_t(std::max(steps, 0.0)), firstOfRun(place), begin + last);
}

History::History(uint64_t mostSteps)
    : m_mostSteps(mostSteps) {}

void History::setOrigin(const Origin &origin) {
    m_origin = origin;
    m_place.reset();
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
    const bool isOtherScene = m_place && m_place->scene != engine.scene();
    const bool isRun = m_blocks.empty() || isOtherScene || !isSameBits(m_last, engine.previous());
    if (needsBlock(engine, isRun)) openBlock(engine, isRun);
    m_last = engine.state();
    m_blocks.back().hashes.push_back(phys_state_hash(&m_last));
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
    for (const Block &block : m_blocks) {
        if (block.begin + block.hashes.size() <= from || block.begin >= to) continue;
        const bool isFirst = recording.segments.empty();
        if (isFirst) past.begin = block.begin;
        recording.segments.push_back(segmentOf(block, isFirst));
        std::vector<uint64_t> &hashes = recording.segments.back().hashes;
        hashes.resize(std::min<uint64_t>(hashes.size(), to - block.begin));
        past.keyframes.push_back({block.begin - past.begin, recording.segments.size() - 1, block.from, block.sums});
        if (block.place.get() != place) addMaze(mazes, *block.place);
        place = block.place.get();
    }
    past.recording = PlayableRecording::ofMazes(std::move(recording), m_origin.registry, std::move(mazes), error);
    if (!past.recording) return std::nullopt;
    return past;
}

} // namespace inspector
