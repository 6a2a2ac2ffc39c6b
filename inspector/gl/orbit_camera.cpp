// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/orbit_camera.h"

#include "gl/board_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace inspector::gl {

namespace {

using Corners = std::vector<glm::dvec3>;

constexpr double kRadiansPerPixel = 0.006;
constexpr double kZoomPerStep = 0.88;
constexpr double kFilledShare = 0.95; ///< share of the picture's width and height; the rest is margin

const double kTangent = std::tan(0.5 * OrbitCamera::kFieldOfView);

/// The positions of the bounds' corners while the board tilts. They are farthest out at full tilt, or so nearly that
/// the margin covers the difference.
Corners sweptCorners(const Bounds &bounds, double largestTilt) {
    const glm::dvec3 pivot = boardPivot(bounds);
    Corners corners;
    for (const double tiltX : {-largestTilt, 0.0, largestTilt}) {
        for (const double tiltY : {-largestTilt, 0.0, largestTilt}) {
            const glm::dmat4 pose = boardToWorld(tiltX, tiltY, pivot);
            for (int i = 0; i < 8; ++i) {
                const glm::dvec3 corner((i & 1) ? bounds.maximum.x : bounds.minimum.x,
                                        (i & 2) ? bounds.maximum.y : bounds.minimum.y,
                                        (i & 4) ? bounds.maximum.z : bounds.minimum.z);
                corners.emplace_back(pose * glm::dvec4(corner, 1.0));
            }
        }
    }
    return corners;
}

} // namespace

void OrbitCamera::setViewport(const glm::dvec2 &size) { m_viewport = glm::max(size, glm::dvec2(1.0)); }

void OrbitCamera::setBounds(const Bounds &bounds, double largestTilt) {
    m_bounds = bounds;
    m_largestTilt = largestTilt;
    keepWithinLimits();
}

void OrbitCamera::orbit(const glm::dvec2 &drag) {
    m_azimuth = std::remainder(m_azimuth - kRadiansPerPixel * drag.x, 2.0 * std::numbers::pi);
    m_elevation += kRadiansPerPixel * drag.y;
    keepWithinLimits();
}

void OrbitCamera::pan(const glm::dvec2 &drag) {
    const Axes camera = axes();
    m_target += metresPerPixel() * (-drag.x * camera.right + drag.y * camera.up);
    keepWithinLimits();
}

void OrbitCamera::zoom(double steps, const glm::dvec2 &cursor) {
    // Scaling eye and target towards the point under the cursor keeps the ray to that point.
    const Axes camera = axes();
    const glm::dvec2 offset = (cursor - 0.5 * m_viewport) * metresPerPixel();
    const glm::dvec3 fixedPoint = m_target + offset.x * camera.right - offset.y * camera.up;
    const double oldDistance = m_distance;
    m_distance *= std::pow(kZoomPerStep, steps);
    keepWithinLimits();
    m_target = fixedPoint + (m_target - fixedPoint) * (m_distance / oldDistance);
    keepWithinLimits();
}

void OrbitCamera::reset() {
    m_azimuth = kStartAzimuth;
    m_elevation = kStartElevation;
    fit();
}

void OrbitCamera::fit() {
    // A corner with camera coordinates (x, y, z back) relative to the centre lies inside the picture when
    //   +-(y - u) <= (d - z) t,  so  y + z t <= d t + u  and  -y + z t <= d t - u,
    // with d the distance, u the shift of the target and t the tangent of half the angle (a little less leaves air).
    // With A and B the largest left sides, u = (A - B)/2 centres the corners and d = (A + B)/(2 t) just shows them; the
    // same for x.
    const Axes camera = axes();
    const glm::dvec3 centre = m_bounds.centre();
    const glm::dvec2 tangent = kFilledShare * kTangent * glm::dvec2(m_viewport.x / m_viewport.y, 1.0);
    glm::dvec2 positive(-std::numeric_limits<double>::infinity());
    glm::dvec2 negative = positive;
    for (const glm::dvec3 &corner : sweptCorners(m_bounds, m_largestTilt)) {
        const glm::dvec3 offset = corner - centre;
        const glm::dvec2 across(glm::dot(offset, camera.right), glm::dot(offset, camera.up));
        const double back = glm::dot(offset, camera.back);
        positive = glm::max(positive, across + back * tangent);
        negative = glm::max(negative, -across + back * tangent);
    }
    const glm::dvec2 shift = 0.5 * (positive - negative);
    const glm::dvec2 distance = 0.5 * (positive + negative) / tangent;
    m_target = centre + shift.x * camera.right + shift.y * camera.up;
    m_distance = std::max(distance.x, distance.y);
    keepWithinLimits();
}

void OrbitCamera::lookAt(const glm::dvec3 &world) {
    m_target = world;
    keepWithinLimits();
}

void OrbitCamera::approach(double share) {
    m_distance *= share;
    keepWithinLimits();
}

glm::dmat4 OrbitCamera::view() const {
    const auto [right, up, back] = axes();
    const glm::dvec3 origin = eye();
    glm::dmat4 matrix(1.0);
    for (int column = 0; column < 3; ++column) {
        matrix[column] = glm::dvec4(right[column], up[column], back[column], 0.0);
    }
    matrix[3] = glm::dvec4(-glm::dot(right, origin), -glm::dot(up, origin), -glm::dot(back, origin), 1.0);
    return matrix;
}

glm::dmat4 OrbitCamera::projection() const {
    // Everything lies within a few radii of the target; a small ratio of far to near suits 16 bits of depth.
    const double nearPlane = std::max(0.02 * m_distance, m_distance - 2.5 * radius());
    const double farPlane = m_distance + 4.0 * radius();
    return glm::perspective(kFieldOfView, m_viewport.x / m_viewport.y, nearPlane, farPlane);
}

glm::dvec3 OrbitCamera::eye() const { return m_target + m_distance * axes().back; }

glm::dvec2 OrbitCamera::project(const glm::dvec3 &world) const {
    const glm::dvec4 clip = projection() * view() * glm::dvec4(world, 1.0);
    const glm::dvec2 normalised = glm::dvec2(clip) / clip.w;
    return {0.5 * (1.0 + normalised.x) * m_viewport.x, 0.5 * (1.0 - normalised.y) * m_viewport.y};
}

Ray OrbitCamera::ray(const glm::dvec2 &pixel) const {
    const Axes camera = axes();
    const glm::dvec2 offset = (pixel - 0.5 * m_viewport) * metresPerPixel();
    return {eye(), glm::normalize(offset.x * camera.right - offset.y * camera.up - m_distance * camera.back)};
}

Ray OrbitCamera::pickRay(const glm::dvec2 &pixel, const glm::dmat4 &worldFromBoard) const {
    const Ray world = ray(pixel);
    const glm::dmat4 boardFromWorld = glm::inverse(worldFromBoard);
    return {glm::dvec3(boardFromWorld * glm::dvec4(world.origin, 1.0)),
            glm::normalize(glm::dvec3(boardFromWorld * glm::dvec4(world.direction, 0.0)))};
}

OrbitCamera::Axes OrbitCamera::axes() const {
    // Written out instead of lookAt(), which is singular straight from above.
    const double ca = std::cos(m_azimuth);
    const double sa = std::sin(m_azimuth);
    const double ce = std::cos(m_elevation);
    const double se = std::sin(m_elevation);
    return {{-sa, ca, 0.0}, {-se * ca, -se * sa, ce}, {ce * ca, ce * sa, se}};
}

double OrbitCamera::metresPerPixel() const { return 2.0 * m_distance * kTangent / m_viewport.y; }

double OrbitCamera::radius() const { return std::max(0.5 * glm::length(m_bounds.size()), 1e-3); }

void OrbitCamera::keepWithinLimits() {
    m_elevation = std::clamp(m_elevation, kMinElevation, kMaxElevation);
    m_distance = std::clamp(m_distance, 0.15 * radius(), 12.0 * radius());
    m_target = glm::clamp(m_target, m_bounds.minimum - 0.5 * radius(), m_bounds.maximum + 0.5 * radius());
}

} // namespace inspector::gl
