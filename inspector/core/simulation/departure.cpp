// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/departure.h"

#include "core/setup/ball_place.h"

#include <QCoreApplication>

namespace inspector {

namespace {

constexpr double kTouchingShare = 0.1; ///< of the radius: a ball that starts less deep in a box touches it

struct Start {
    Q_DECLARE_TR_FUNCTIONS(Start)
};

} // namespace

BoardSide boardSide(const phys_scene *scene, const phys_vec3 &centre) {
    phys_box bounds;
    phys_scene_bounds(scene, &bounds);
    const bool isOver =
        centre.x >= bounds.min.x && centre.x <= bounds.max.x && centre.y >= bounds.min.y && centre.y <= bounds.max.y;
    if (!isOver) return BoardSide::Beside;
    return centre.z < bounds.min.z - phys_scene_radius(scene) ? BoardSide::Below : BoardSide::Within;
}

QString startFault(const phys_scene *scene, const phys_vec3 &centre) {
    if (phys_scene_box_count(scene) == 0) return Start::tr("this maze has no board");
    const BoardSide side = boardSide(scene, centre);
    if (side == BoardSide::Beside) return Start::tr("the ball starts beside the board");
    if (side == BoardSide::Below) return Start::tr("the ball starts below the board");
    const double touching = kTouchingShare * phys_scene_radius(scene);
    return overlapOf(scene, centre) > touching ? Start::tr("the ball starts in a box") : QString();
}

/// A ball that has left doesn't come back, so a binary search finds the first sample outside.
std::optional<Departure> departure(const SampleRing &samples, const phys_scene *scene, double time) {
    std::optional<Departure> found;
    Sample sample;
    uint64_t begin = samples.first();
    uint64_t middle = samples.find(time);
    uint64_t end = middle + 1;
    while (begin < end && samples.read(middle, sample)) {
        const phys_vec3 centre{sample[Channel::PositionX], sample[Channel::PositionY], sample[Channel::PositionZ]};
        const BoardSide side = boardSide(scene, centre);
        if (side == BoardSide::Within && !found) return std::nullopt; // at `time`
        if (side == BoardSide::Within) {
            begin = middle + 1;
        } else {
            found = {sample.time, side};
            end = middle;
        }
        middle = begin + (end - begin) / 2;
    }
    return found;
}

} // namespace inspector
