// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/playable_recording.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

/// The candidate paths of the maze on this machine; a path that is in the list of levels is returned as that level.
std::vector<Level> placesOf(const QString &path, const QString &recording, const std::vector<Level> &levels) {
    const QString name = path.section(QLatin1Char('/'), -1);
    std::vector<Level> places;
    for (const Level &level : levels)
        if (isSameFile(level.path, path)) places.push_back(level);
    places.push_back(levelOfFile(path));
    places.push_back(levelOfFile(recording.left(recording.lastIndexOf(QLatin1Char('/')) + 1) + name));
    for (const Level &level : levels)
        if (level.path.section(QLatin1Char('/'), -1) == name) places.push_back(level);
    return places;
}

/// The maze with the recorded hash. Returns nothing, with one line in `error`, if there is none.
std::optional<Level> findMaze(const MazeSource &maze, const QString &recording, const std::vector<Level> &levels,
                              QString *error) {
    QString found;
    for (const Level &place : placesOf(maze.path, recording, levels)) {
        const std::optional<QByteArray> text = readFile(place.path, kLargestMaze, nullptr);
        if (!text) continue;
        const uint64_t hash = hashOf(*text);
        if (hash == maze.hash) return place;
        if (found.isEmpty())
            found = QStringLiteral("expected a maze file with the hash %1, found %2 with %3")
                        .arg(QString::fromLatin1(hashText(maze.hash)), quoted(place.path),
                             QString::fromLatin1(hashText(hash)));
    }
    *error = found.isEmpty() ? QStringLiteral("expected the maze file %1 there, beside the recording or among the "
                                              "levels, found none")
                                   .arg(quoted(maze.path))
                             : found;
    return std::nullopt;
}

} // namespace

PlayableRecording::PlayableRecording(Recording recording, Registry registry)
    : m_recording(std::move(recording))
    , m_registry(std::move(registry)) {}

std::shared_ptr<const PlayableRecording> PlayableRecording::make(Recording recording, const Registry &registry,
                                                                 const std::vector<Level> &levels, QString *error) {
    const std::shared_ptr<PlayableRecording> made(new PlayableRecording(std::move(recording), registry));
    for (size_t index = 0; index < made->m_recording.segments.size(); ++index)
        if (!made->add(index, levels, error)) return nullptr;
    return made;
}

std::shared_ptr<const PlayableRecording> PlayableRecording::ofMazes(Recording recording, const Registry &registry,
                                                                    std::vector<Maze> mazes, QString *error) {
    const std::shared_ptr<PlayableRecording> made(new PlayableRecording(std::move(recording), registry));
    made->m_mazes = std::move(mazes);
    for (size_t index = 0; index < made->m_recording.segments.size(); ++index)
        if (!made->add(index, {}, error)) return nullptr;
    return made;
}

bool PlayableRecording::add(size_t index, const std::vector<Level> &levels, QString *error) {
    const Segment &now = segment(index);
    const auto refuse = [&](int line, const QString &reason) {
        if (error) *error = QStringLiteral("%1:%2: %3").arg(oneLine(m_recording.file)).arg(line).arg(reason);
        return false;
    };
    QString reason;
    const std::optional<size_t> maze = addMaze(now.conditions.maze, levels, &reason);
    if (!maze) return refuse(now.mazeLine, reason);
    const Stepper stepper = stepperFor(index, *maze, &reason);
    if (!stepper) return refuse(now.stepperLine, reason);
    m_places.push_back({m_length, *maze, stepper, stepperIndex(m_registry, now.conditions.stepper.id)});
    if (now.from && (m_runs.empty() || m_runs.back() != m_length)) m_runs.push_back(m_length);
    m_length += now.hashes.size();
    return true;
}

std::optional<size_t> PlayableRecording::addMaze(const MazeSource &source, const std::vector<Level> &levels,
                                                 QString *error) {
    const auto known =
        std::find_if(m_mazes.begin(), m_mazes.end(), [&](const Maze &maze) { return maze.source == source; });
    if (known != m_mazes.end()) return size_t(known - m_mazes.begin());
    const std::optional<Level> level = findMaze(source, m_recording.file, levels, error);
    if (!level) return std::nullopt;
    const Scene scene = loadScene(level->path, error);
    if (!scene) return std::nullopt;
    m_mazes.push_back({source, *level, scene});
    return m_mazes.size() - 1;
}

/// Reuses the previous segment's stepper if it is the same: most segments differ only by a tilt.
Stepper PlayableRecording::stepperFor(size_t index, size_t maze, QString *error) const {
    const QByteArray &id = segment(index).conditions.stepper.id;
    const bool isSame = index > 0 && m_places.back().maze == maze && segment(index - 1).conditions.stepper.id == id;
    return isSame ? m_places.back().stepper : makeStepper(m_registry, id, m_mazes[maze].scene, error);
}

uint64_t PlayableRecording::positionAt(double seconds) const {
    for (size_t index = 0; index < m_places.size(); ++index) {
        const double dt = segment(index).conditions.dt;
        const double steps = std::round(seconds / dt); // rounded: 0.3 s is 30 steps of 0.01 s, not 29
        if (steps < double(segment(index).hashes.size())) return begin(index) + uint64_t(std::max(0.0, steps));
        seconds -= dt * double(segment(index).hashes.size());
    }
    return m_length;
}

StepSpan PlayableRecording::run(size_t index) const {
    return {m_runs[index], index + 1 < m_runs.size() ? m_runs[index + 1] : m_length};
}

size_t PlayableRecording::runIndexAt(uint64_t position) const {
    const auto next = std::lower_bound(m_runs.begin(), m_runs.end(), std::max<uint64_t>(position, 1));
    return size_t(next - m_runs.begin()) - 1;
}

uint64_t PlayableRecording::stepsUntil(double time, size_t run) const {
    constexpr double kStepRounding = 1e-6; // share of a step
    const StepSpan steps = this->run(run);
    double begin = 0.0; // s, of the segment
    for (size_t index = 0; index < m_places.size() && this->begin(index) < steps.end; ++index) {
        if (segment(index).from) begin = segment(index).from->time;
        const double dt = segment(index).conditions.dt;
        const double made = std::max(0.0, std::ceil((time - begin) / dt - kStepRounding));
        if (this->begin(index) >= steps.begin && made <= double(segment(index).hashes.size()))
            return this->begin(index) + uint64_t(made) - steps.begin;
        begin += dt * double(segment(index).hashes.size());
    }
    return steps.count();
}

uint64_t PlayableRecording::positionAt(double time, uint64_t position) const {
    const size_t run = runIndexAt(position);
    const uint64_t begin = m_runs[run];
    return std::max(begin + stepsUntil(time, run), begin == 0 ? 0 : begin + 1); // `begin` shows the run before
}

std::shared_ptr<const PlayableRecording> openRecording(const QString &path, const Registry &registry,
                                                       const std::vector<Level> &levels, QString *error) {
    std::optional<Recording> recording = readRecording(path, registry, error);
    return recording ? PlayableRecording::make(*std::move(recording), registry, levels, error) : nullptr;
}

} // namespace inspector
