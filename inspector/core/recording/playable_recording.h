// SPDX-License-Identifier: GPL-3.0-or-later
// A recording made ready to run here: its mazes are found and loaded, its steppers made. Whatever keeps a recording
// from being followed comes out at this point, before the first step.
#pragma once

#include "core/recording/recording.h"
#include "core/setup/levels.h"

#include <memory>
#include <vector>

namespace inspector {

// Never changes; any thread, but steppers belong to the one thread that makes steps. A position in a recording is how
// many of its steps are made: 0 .. length().
class PlayableRecording {
public:
    struct Maze {
        MazeSource source;
        Level level;
        Scene scene;
    };
    // Of mazes that are open already; others are looked for nowhere.
    static std::shared_ptr<const PlayableRecording> ofMazes(Recording recording, const Registry &registry,
                                                            std::vector<Maze> mazes, QString *error);
    // A maze is looked for where the recording says, then beside the recording, then among the levels; one with the
    // recorded hash is taken. Null and one line in `error` that begins with file and line if something is missing.
    static std::shared_ptr<const PlayableRecording> make(Recording recording, const Registry &registry,
                                                         const std::vector<Level> &levels, QString *error);

    const Recording &recording() const { return m_recording; }
    const Registry &registry() const { return m_registry; }
    uint64_t length() const { return m_length; } // steps
    // The position that the recording has reached after so many seconds of steps, all runs counted.
    uint64_t positionAt(double seconds) const;
    // Where the run began that the step before `position` belongs to: the last start, restart or other state.
    uint64_t beginOfRun(uint64_t position) const;
    // Where runs begin, in order; the first is 0.
    const std::vector<uint64_t> &runs() const { return m_runs; }

    // Of segment `index`, 0 .. recording().segments.size() - 1.
    const Segment &segment(size_t index) const { return m_recording.segments[index]; }
    uint64_t begin(size_t index) const { return m_places[index].begin; } // steps before it
    uint64_t end(size_t index) const { return begin(index) + segment(index).hashes.size(); }
    const Level &level(size_t index) const { return m_mazes[m_places[index].maze].level; } // as found here
    const Scene &scene(size_t index) const { return m_mazes[m_places[index].maze].scene; }
    const Stepper &stepper(size_t index) const { return m_places[index].stepper; }
    uint32_t stepperPlace(size_t index) const { return m_places[index].stepperPlace; } // in the registry

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
    std::vector<Maze> m_mazes;   // each once
    std::vector<Place> m_places; // of the segments
    std::vector<uint64_t> m_runs;
};

// The recording of a file, ready to run; null and one line in `error` as above, or as readRecording().
std::shared_ptr<const PlayableRecording> openRecording(const QString &path, const Registry &registry,
                                                       const std::vector<Level> &levels, QString *error);

} // namespace inspector
