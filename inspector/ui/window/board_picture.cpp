// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/board_picture.h"

#include "core/setup/ball_place.h"
#include "mesh/mesh_builder.h"
#include "mesh/mesh_file.h"
#include "ui/parts/board_vector.h"
#include "ui/parts/theme.h"

#include <QFileInfo>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace inspector::ui {

namespace {

constexpr double kTrailTime = 1.5;         ///< s, simulated
constexpr double kComparedTrailTime = 3.0; ///< s, simulated
constexpr uint64_t kTrailPoints = 300;
constexpr size_t kTrackPoints = 1000;
constexpr double kTrailAlpha = 0.9;
constexpr float kTrailWidth = 3.0F;     ///< logical pixels
constexpr float kBallTrailWidth = 4.0F; ///< next to a ghost's
constexpr float kGhostTrailWidth = 2.0F;
constexpr double kWayAlpha = 0.8;
constexpr double kOtherWayAlpha = 0.3;
constexpr float kOtherWayWidth = 1.5F;
constexpr double kOldAlpha = 0.45;
constexpr double kGhostAlpha = 0.55;
constexpr double kGhostSize = 0.99; ///< share of the ball's radius, so that the ball hides it where both coincide

gl::Ball ballOf(const phys_state &state, double radius) {
    gl::Ball ball;
    ball.position = toGlm(state.position);
    std::copy(std::begin(state.orientation), std::end(state.orientation), ball.orientation.begin());
    ball.radius = radius;
    return ball;
}

/// One ball's path from `begin` to `end`.
struct PastWay {
    Channel x, y, z;
    double begin; ///< s
    phys_state end;
};

/// Limits the number of points by taking every n-th sample, counted from 0 so that the points don't shift.
std::vector<glm::dvec3> pointsOf(const SampleRing &samples, const PastWay &way) {
    std::vector<glm::dvec3> points;
    const uint64_t last = samples.last();
    const uint64_t begin = std::max(samples.first(), samples.find(way.begin));
    if (begin >= last) return points;
    const uint64_t stride = (last - begin) / kTrailPoints + 1;
    Sample sample;
    for (uint64_t number = (begin + stride - 1) / stride * stride; number < last; number += stride) {
        if (!samples.read(number, sample) || sample.time > way.end.time || std::isnan(sample[way.x])) continue;
        points.emplace_back(sample[way.x], sample[way.y], sample[way.z]);
    }
    points.push_back(toGlm(way.end.position));
    return points;
}

gl::Colour withAlpha(const QColor &colour, double alpha) {
    return {colour.redF(), colour.greenF(), colour.blueF(), static_cast<float>(alpha)};
}

/// The ghost with its trail, which is above the ball's and thinner, so that both are visible where they coincide.
void addGhost(gl::Frame &frame, const SampleRing &samples, const phys_state &state, double metAt) {
    const QColor colour = accentsFor(QGuiApplication::palette()).ghost;
    gl::GhostBall ghost{ballOf(state, kGhostSize * frame.ball.radius), withAlpha(colour, kGhostAlpha)};
    frame.ghosts.push_back(ghost);
    // The sample at the restart itself still has the ghost's earlier position.
    const double afterMeeting = std::nextafter(metAt, std::numeric_limits<double>::infinity());
    const double begin = std::max(state.time - kComparedTrailTime, afterMeeting);
    const PastWay way{Channel::GhostX, Channel::GhostY, Channel::GhostZ, begin, state};
    frame.trails.push_back({pointsOf(samples, way), withAlpha(colour, kTrailAlpha), kGhostTrailWidth});
}

/// The measured ball at that time, and its whole path; only x and y were measured, of a ball on the floor.
void addTrack(gl::Frame &frame, const ShownTrack &track, const phys_scene *scene, double time) {
    const QColor colour = accentsFor(QGuiApplication::palette()).selected;
    const double height = track.start(scene).position.z;
    gl::Trail all{{}, withAlpha(colour, kOldAlpha), kGhostTrailWidth};
    gl::Trail lately{{}, withAlpha(colour, kTrailAlpha), kGhostTrailWidth};
    const size_t stride = track.points().size() / kTrackPoints + 1;
    for (size_t i = 0; i < track.points().size(); ++i) {
        const TrackPoint &point = track.points()[i];
        if (i % stride == 0) all.points.emplace_back(point.x, point.y, height);
        const bool isLately = point.time <= time && point.time >= time - kComparedTrailTime;
        if (isLately) lately.points.emplace_back(point.x, point.y, height);
    }
    frame.trails.push_back(std::move(all));
    const std::optional<ShownTrack::Place> place = track.at(time);
    if (!place) return;
    gl::GhostBall ghost{frame.ball, withAlpha(colour, kGhostAlpha)};
    ghost.ball.radius *= kGhostSize;
    ghost.ball.position = {place->x, place->y, height};
    lately.points.push_back(ghost.ball.position);
    frame.ghosts.push_back(ghost);
    frame.trails.push_back(std::move(lately));
}

glm::dvec3 positionOf(const Sample &sample) {
    return {sample[Channel::PositionX], sample[Channel::PositionY], sample[Channel::PositionZ]};
}

/// Another run: its path, and its ball while it has one at that time.
void addBeside(gl::Frame &frame, const std::vector<Sample> &samples, double time) {
    if (samples.empty()) return;
    gl::Trail trail{{}, withAlpha(accentsFor(QGuiApplication::palette()).ball, kOldAlpha), kGhostTrailWidth};
    const size_t stride = samples.size() / kTrailPoints + 1;
    for (size_t i = samples.size(); i-- > 0;) // fades towards its far end
        if (i % stride == 0) trail.points.push_back(positionOf(samples[i]));
    frame.trails.push_back(std::move(trail));
    const auto next = std::ranges::lower_bound(samples, time, {}, &Sample::time);
    if (next == samples.begin() || next == samples.end()) return;
    const Sample &last = *std::prev(next);
    const double share = (time - last.time) / (next->time - last.time);
    gl::GhostBall ball{frame.ball, frame.trails.back().colour};
    ball.ball.radius *= kGhostSize;
    ball.ball.position = glm::mix(positionOf(last), positionOf(*next), share);
    frame.ghosts.push_back(ball);
}

/// The path ahead, fading towards its far end.
gl::Trail trailAhead(const Way &way, const gl::Colour &colour, float width) {
    gl::Trail trail{{}, colour, width};
    std::transform(way.rbegin(), way.rend(), std::back_inserter(trail.points),
                   [](const phys_vec3 &point) { return toGlm(point); });
    return trail;
}

} // namespace

gl::Frame currentFrame(Session &session) {
    const Snapshot now = session.simulation().latest();
    const SampleRing &samples = session.simulation().samples();
    const Clock::time_point moment = Clock::now();
    const phys_state state = interpolated(now, moment);
    const double trailTime = now.ghost ? kComparedTrailTime : kTrailTime;
    const PastWay way{Channel::PositionX, Channel::PositionY, Channel::PositionZ, state.time - trailTime, state};
    gl::Frame frame;
    frame.tiltX = now.inputs.tilt.x;
    frame.tiltY = now.inputs.tilt.y;
    frame.ball = ballOf(state, phys_scene_radius(session.scene().get()));
    frame.trails.push_back({pointsOf(samples, way), withAlpha(accentsFor(QGuiApplication::palette()).ball, kTrailAlpha),
                            now.ghost ? kBallTrailWidth : kTrailWidth});
    addBeside(frame, *session.samplesBeside(), state.time);
    if (session.track()) addTrack(frame, *session.track(), session.scene().get(), state.time);
    if (const auto ghost = interpolatedGhost(now, moment)) addGhost(frame, samples, *ghost, now.ghost->met.time);
    return frame;
}

void addWayAhead(gl::Frame &frame, const WayAhead &way) {
    if (way.points.size() < 2) return;
    const QColor colour = accentsFor(QGuiApplication::palette()).total;
    for (const Way &other : way.others)
        frame.trails.push_back(trailAhead(other, withAlpha(colour, kOtherWayAlpha), kOtherWayWidth));
    frame.trails.push_back(trailAhead(way.points, withAlpha(colour, kWayAlpha), kGhostTrailWidth));
    if (!way.bounce) return;
    const gl::Colour mark = withAlpha(colour, 1.0);
    frame.strokes.point(toGlm(way.bounce->point), mark, 7.0F);
    frame.strokes.arrow(toGlm(way.bounce->point), toGlm(way.bounce->normal), frame.ball.radius, mark, 2.0F);
}

gl::Mesh mazeMesh(Session &session, QString *error) {
    const Scene &scene = session.scene();
    if (!session.level().mesh.isEmpty())
        if (std::optional<gl::Mesh> mesh = gl::loadMesh(session.level().mesh, error)) return *std::move(mesh);
    const phys_box *boxes = phys_scene_boxes(scene.get());
    const double kerb = startingFloor(scene.get()) + 0.5 * phys_scene_radius(scene.get());
    std::vector<gl::MazeBox> pieces;
    for (uint32_t i = 0; i < phys_scene_box_count(scene.get()); ++i) {
        const bool isWall = boxes[i].max.z > kerb;
        pieces.push_back({toGlm(boxes[i].min), toGlm(boxes[i].max), isWall ? gl::BoxKind::Wall : gl::BoxKind::Floor});
    }
    for (const phys_box &exit : session.levels().exits().value_or(std::vector<phys_box>()))
        pieces.push_back({toGlm(exit.min), toGlm(exit.max), gl::BoxKind::Exit});
    return gl::mazeFromBoxes(pieces);
}

gl::Mesh ballMesh(QString *error) {
    const QString path = levelsFolder() + QStringLiteral("/ball.obj");
    if (QFileInfo::exists(path))
        if (std::optional<gl::Mesh> mesh = gl::loadMesh(path, error)) return *std::move(mesh);
    return gl::patternedBall();
}

} // namespace inspector::ui
