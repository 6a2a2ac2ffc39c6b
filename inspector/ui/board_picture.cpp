// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/board_picture.h"

#include "gl/mesh_builder.h"
#include "gl/mesh_file.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kTrailTime = 1.5; // s, simulated
constexpr uint64_t kTrailPoints = 150;

glm::dvec3 toGlm(const phys_vec3 &v) { return {v.x, v.y, v.z}; }

gl::Ball ballOf(const phys_state &state, double radius) {
    gl::Ball ball;
    ball.position = toGlm(state.position);
    std::copy(std::begin(state.orientation), std::end(state.orientation), ball.orientation.begin());
    ball.radius = radius;
    return ball;
}

// Every n-th sample, n so that the number of points stays small, counted from 0 so that they don't creep.
gl::Trail trailOf(const SampleRing &samples, const phys_state &end) {
    gl::Trail trail;
    const uint64_t last = samples.last();
    const uint64_t begin = std::max(samples.first(), samples.find(end.time - kTrailTime));
    if (begin >= last) return trail;
    const uint64_t stride = (last - begin) / kTrailPoints + 1;
    Sample sample;
    for (uint64_t number = (begin + stride - 1) / stride * stride; number < last; number += stride) {
        if (!samples.read(number, sample) || sample.time > end.time) continue;
        trail.points.emplace_back(sample[Channel::PositionX], sample[Channel::PositionY], sample[Channel::PositionZ]);
    }
    trail.points.push_back(toGlm(end.position));
    return trail;
}

} // namespace

gl::Frame currentFrame(Session &session) {
    const Snapshot &now = session.simulation().latest();
    const phys_state state = interpolated(now, Clock::now());
    gl::Frame frame;
    frame.tilt_x = now.inputs.tilt.x;
    frame.tilt_y = now.inputs.tilt.y;
    frame.ball = ballOf(state, phys_scene_radius(session.scene().get()));
    frame.trails.push_back(trailOf(session.simulation().samples(), state));
    return frame;
}

gl::Mesh mazeMesh(const Level &level, const Scene &scene, QString *error) {
    if (!level.mesh.isEmpty())
        if (std::optional<gl::Mesh> mesh = gl::loadMesh(level.mesh, error)) return *std::move(mesh);
    phys_state start;
    phys_scene_start(scene.get(), &start);
    const phys_box *boxes = phys_scene_boxes(scene.get());
    const double floor = start.position.z - 0.5 * phys_scene_radius(scene.get());
    std::vector<gl::MazeBox> pieces;
    for (uint32_t i = 0; i < phys_scene_box_count(scene.get()); ++i) {
        const bool isWall = boxes[i].max.z > floor;
        pieces.push_back({toGlm(boxes[i].min), toGlm(boxes[i].max), isWall ? gl::BoxKind::Wall : gl::BoxKind::Floor});
    }
    return gl::mazeFromBoxes(pieces);
}

gl::Mesh ballMesh(QString *error) {
    const QString path = levelsFolder() + QStringLiteral("/ball.obj");
    if (QFileInfo::exists(path))
        if (std::optional<gl::Mesh> mesh = gl::loadMesh(path, error)) return *std::move(mesh);
    return gl::patternedBall();
}

} // namespace inspector::ui
