// SPDX-License-Identifier: GPL-3.0-or-later
// The most recent steps of the live ball, kept in memory so that each of them can be repeated and all of them be saved
// as a recording afterwards.
#pragma once

#include "core/engine/engine.h"
#include "core/recording/playable_recording.h"
#include "core/recording/recorder.h"
#include "core/recording/replay.h"

#include <deque>
#include <memory>
#include <vector>

namespace inspector {

/// A copy of the history, ready to be replayed. Places number the states since the program began: a run of n steps has
/// n + 1, from the state in which it begins; positions in the recording count its steps.
struct Past {
    std::shared_ptr<const PlayableRecording> recording;
    std::vector<Keyframe> keyframes; ///< ascending, at most History::kBlockSteps apart, the first at 0
    uint64_t begin = 0;

    uint64_t end() const { return endOf(recording->runs().size() - 1); }
    /// The first and the last place of the run of `place`.
    uint64_t beginOfRun(uint64_t place) const { return beginOf(runIndexAt(place)); }
    uint64_t endOfRun(uint64_t place) const { return endOf(runIndexAt(place)); }
    uint64_t positionOf(uint64_t place) const { return place - begin - runIndexAt(place); }
    /// segment: of the last step, or of the next one at a run's begin.
    uint64_t placeOf(uint64_t position, size_t segment) const;
    /// The first place at or after `time`, s, in the run of `place`; the run's end if it doesn't last that long.
    uint64_t placeAt(double time, uint64_t place) const;

private:
    uint64_t beginOf(size_t run) const { return begin + recording->run(run).begin + run; }
    uint64_t endOf(size_t run) const { return begin + recording->run(run).end + run; }
    size_t runIndexAt(uint64_t place) const;
};

/// Memory: 8 bytes a step and about 700 for each change of tilt, parameters or step size: at most 55 MB, and 20 MB for
/// 10 minutes at 1 ms under the autopilot, which tilts anew every 20 ms.
class History {
public:
    static constexpr uint64_t kMostSteps = uint64_t(1) << 20; ///< 17 minutes at 1 ms
    static constexpr size_t kMostBlocks = size_t(1) << 16;
    static constexpr uint64_t kBlockSteps = 512; ///< also the most steps that any jump takes

    explicit History(uint64_t mostSteps = kMostSteps);

    /// Takes effect from the next step on.
    void setOrigin(const Origin &origin);
    /// The next step continues from a state that was set.
    void beginRun();
    /// The next step continues the last run that has steps, which began at this place.
    void resumeRun(uint64_t begin);
    /// Called after each step of the engine.
    void note(const Engine &engine);

    /// Places [begin(), end()] can be shown again, except for end() while the last run has no step.
    uint64_t begin() const { return m_blocks.empty() ? m_end : m_blocks.front().begin; }
    uint64_t beginOfLastRun() const { return m_run; } ///< which may have been dropped
    uint64_t end() const { return m_end; }
    /// A copy of the part of [from, to) that is kept. Returns nothing, with one line in `error`, if a stepper is no
    /// longer available.
    std::optional<Past> past(uint64_t from, uint64_t to, QString *error) const;

private:
    /// The scene and stepper of steps, shared by their blocks.
    struct Place {
        Origin origin;
        Scene scene;
    };
    /// Consecutive steps under the same conditions.
    struct Block {
        uint64_t begin;
        std::shared_ptr<const Place> place;
        double dt; ///< s
        Inputs inputs;
        phys_state from;
        EnergySums sums; ///< at the block's begin
        bool isRun;      ///< begins a run: doesn't continue the previous block
        std::vector<uint64_t> hashes;
    };

    bool needsBlock(const Engine &engine, bool isRun) const;
    void openBlock(const Engine &engine, bool isRun);
    void dropOldest();
    static void addMaze(std::vector<PlayableRecording::Maze> &mazes, const Place &place);
    static Segment segmentOf(const Block &block, bool isFirst);

    uint64_t m_mostSteps;
    Origin m_origin;
    std::shared_ptr<const Place> m_place; ///< of the next steps; null: not known yet
    std::deque<Block> m_blocks;
    uint64_t m_run = 0; ///< place where the last run began
    uint64_t m_end = 0;
};

} // namespace inspector
