// SPDX-License-Identifier: GPL-3.0-or-later
// A recording that is ready to run on this machine: its mazes are found and loaded, its steppers created. Whatever
// prevents a replay is reported here, before the first step.
#pragma once

#include "core/recording/recording.h"
#include "core/setup/levels.h"

#include <memory>
#include <vector>

namespace inspector {

/// The steps of a run, [begin, end): those from a start, a restart or a change of state to the next one.
struct StepSpan {
    uint64_t begin = 0;
    uint64_t end = 0;
    uint64_t count() const { return end - begin; }
};

/// Immutable and usable from any thread, but its steppers belong to the one thread that steps. A position in a
/// recording is the number of steps made: 0 .. length().
class PlayableRecording {
public:
    struct Maze {
        MazeSource source;
        Level level;
        Scene scene;
    };
    /// With mazes that are already open; no others are searched for.
    static std::shared_ptr<const PlayableRecording> ofMazes(Recording recording, const Registry &registry,
                                                            std::vector<Maze> mazes, QString *error);
    /// A maze is searched for where the recording says, then next to the recording, then among the levels; the one with
    /// the recorded hash is taken. Null, with one line in `error` that begins with file and line, if something is
    /// missing.
    static std::shared_ptr<const PlayableRecording> make(Recording recording, const Registry &registry,
                                                         const std::vector<Level> &levels, QString *error);

    const Recording &recording() const { return m_recording; }
    const Registry &registry() const { return m_registry; }
    uint64_t length() const { return m_length; } ///< steps
    /// The position after `seconds` of steps, counting all runs.
    uint64_t positionAt(double seconds) const;
    /// The positions at which runs begin, ascending; the first is 0.
    const std::vector<uint64_t> &runs() const { return m_runs; }
    StepSpan run(size_t index) const;
    /// The index of the run of the step before `position`.
    size_t runIndexAt(uint64_t position) const;
    StepSpan runAt(uint64_t position) const { return run(runIndexAt(position)); }
    /// How many steps of a run are made at its first state at or after `time`, s; all if it doesn't last that long.
    uint64_t stepsUntil(double time, size_t run) const;
    /// The first position at or after `time`, s, that shows the run of `position`, or the run's end.
    uint64_t positionAt(double time, uint64_t position) const;

    /// Functions of segment `index`, 0 .. recording().segments.size() - 1.
    const Segment &segment(size_t index) const { return m_recording.segments[index]; }
    uint64_t begin(size_t index) const { return m_places[index].begin; } ///< first position of the segment
    uint64_t end(size_t index) const { return begin(index) + segment(index).hashes.size(); }
    const Level &level(size_t index) const { return m_mazes[m_places[index].maze].level; } ///< as found on this machine
    const Scene &scene(size_t index) const { return m_mazes[m_places[index].maze].scene; }
    const Stepper &stepper(size_t index) const { return m_places[index].stepper; }
    uint32_t stepperPlace(size_t index) const { return m_places[index].stepperPlace; } ///< index in the registry

private:
    struct Place {
        uint64_t begin;
        size_t maze;
        Stepper stepper;
        uint32_t stepperPlace;
    };

    PlayableRecording(Recording recording, Registry registry);
    bool add(size_t index, const std::vector<Level> &levels, QString *error);
    std::optional<size_t> addMaze(const MazeSource &source, const std::vector<Level> &levels, QString *error);
    Stepper stepperFor(size_t index, size_t maze, QString *error) const;

    Recording m_recording;
    Registry m_registry;
    uint64_t m_length = 0;
    std::vector<Maze> m_mazes;   ///< without duplicates
    std::vector<Place> m_places; ///< of the segments
    std::vector<uint64_t> m_runs;
};

/// Loads a recording file, ready to run; null, with one line in `error`, as make() or readRecording().
std::shared_ptr<const PlayableRecording> openRecording(const QString &path, const Registry &registry,
                                                       const std::vector<Level> &levels, QString *error);

} // namespace inspector
