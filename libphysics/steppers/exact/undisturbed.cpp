// SPDX-License-Identifier: MIT
#include "exact/undisturbed.h"

#include "phases/resisted.h"
#include "phases/turning.h"
#include "phases/uniform.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// relative to the numbers beside it, what may be rounding; in such cases the step is left to the general case
constexpr double kUnsure = 1e-9;

double sumOfParts(const phys_vec3 &v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

class Undisturbed {
public:
    Undisturbed(const Scene &scene, const FloorRegion &region, const phys_params &params, double dt,
                const phys_state &in)
        : m_scene(scene)
        , m_region(region)
        , m_params(params)
        , m_in(in)
        , m_dt(dt)
        , m_position(in.position.x, in.position.y, scene.boxes[region.floor].max.z + scene.radius)
        , m_velocity(in.velocity.x, in.velocity.y, 0.0)
        , m_spin(isRigid() ? toVec(in.spin) : rollingSpin(inPlane(in.velocity), scene.radius))
        , m_level(params.gravity.x, params.gravity.y, 0.0)
        , m_pressure(-params.gravity.z) {}

    bool run(phys_state &out, phys_report *report) const {
        if (!rolls()) return false;
        const bool leansX = m_region.along[0].isFace(m_in.position.x);
        const bool leansY = m_region.along[1].isFace(m_in.position.y);
        if (leansX && leansY) return false;
        return leansX || leansY ? rollAlongFace(leansX ? 0 : 1, out, report) : rollFree(out, report);
    }

private:
    bool isRigid() const { return m_params.model == PHYS_MODEL_RIGID; }

    /// Whether the ball certainly moves and, in the rigid model, certainly rolls and continues to.
    bool rolls() const {
        const double R = m_scene.radius, speedSquared = glm::dot(m_velocity, m_velocity);
        const Vec3 surface = R * toVec(m_in.spin);
        constexpr double kStill = 1e-13; // relative: smaller values are rounding
        if (!(speedSquared > kStill * kStill * (R * sumOfParts(m_params.gravity) + glm::dot(surface, surface))))
            return false;
        if (!isRigid()) return true;
        constexpr double kNoSlip = 64.0 * kRounding;
        const Vec2 slip = inPlane(m_velocity) - spinSpeed(m_spin, R);
        const double most = m_params.sliding_friction * m_pressure;
        return glm::dot(slip, slip) <= kNoSlip * kNoSlip * speedSquared &&
               4.0 / 49.0 * glm::dot(m_level, m_level) < most * most;
    }

    bool rollFree(phys_state &out, phys_report *report) const {
        const double resistance = m_params.rolling_friction * m_pressure;
        if (!turnsAgainst(resistance)) return false;
        const Resisted phase = Resisted::rolling(2, m_velocity, 5.0 / 7.0 * m_level, 5.0 / 7.0 * resistance,
                                                 m_scene.radius, m_spin, Vec3(0.0, 0.0, 1.0));
        if (phase.end().after < m_dt) return false;
        if (!m_region.keeps(m_position, m_velocity, m_dt, phase.mostAcceleration())) return false;
        if (report) report->lost_rolling += phase.losses(m_dt).rolling;
        follow(phase, out, report);
        return true;
    }

    /// Whether the path of the ball is certainly curved: its velocity isn't parallel to the drive.
    bool turnsAgainst(double resistance) const {
        constexpr double kLeast = 1e-10; // sine of the angle between the velocity and its rate of change
        const Vec3 &v = m_velocity;
        const double across = v.x * m_level.y - v.y * m_level.x;
        const double most = kLeast * (std::abs(m_level.x) + std::abs(m_level.y) + resistance);
        return resistance > 0.0 && across * across > most * most * glm::dot(v, v);
    }

    /// The drive presses the ball against a face across an axis, so that its acceleration is constant, 14.1.
    bool rollAlongFace(int axis, phys_state &out, phys_report *report) const {
        const double R = m_scene.radius;
        const bool isSmooth = !isRigid() || m_params.wall_friction == 0.0;
        if (!isSmooth || m_velocity[axis] != 0.0 || m_spin[1 - axis] != 0.0) return false;
        const FloorRegion::Range &range = m_region.along[static_cast<size_t>(axis)];
        const bool isLow = m_position[axis] == range.lowFace;
        const Vec3 drive = 5.0 / 7.0 * m_level;
        const double push = isLow ? -drive[axis] : drive[axis];
        const double scale =
            sumOfParts(m_params.gravity) + (glm::dot(m_velocity, m_velocity) + R * R * glm::dot(m_spin, m_spin)) / R;
        if (!(push > (kUnsure + 8.0 * m_scene.tolerance / R) * scale)) return false;

        const Vec3 heading(m_velocity.x > 0.0   ? 1.0
                           : m_velocity.x < 0.0 ? -1.0
                                                : 0.0,
                           m_velocity.y > 0.0   ? 1.0
                           : m_velocity.y < 0.0 ? -1.0
                                                : 0.0,
                           0.0);
        const Vec3 up(0.0, 0.0, 1.0);
        Vec3 a = drive - 5.0 / 7.0 * m_params.rolling_friction * m_pressure * heading;
        a[axis] = 0.0;
        const double slows = -glm::dot(a, heading), speed = glm::dot(m_velocity, heading);
        if (!(slows * m_dt < (1.0 - kUnsure) * speed)) return false;
        const Uniform phase{m_velocity, a, m_spin, glm::cross(up, a) / R};
        if (!m_region.keeps(m_position, m_velocity, m_dt, slows < 0.0 ? -slows : slows)) return false;
        if (report) {
            const double middle = std::abs(glm::dot(phase.spinAt(0.5 * m_dt), glm::cross(up, heading)));
            report->lost_rolling += m_params.rolling_friction * m_pressure * R * m_dt * middle;
        }
        follow(phase, out, report);
        out.position.x = axis == 0 ? (isLow ? range.lowFace : range.highFace) : out.position.x;
        out.position.y = axis == 1 ? (isLow ? range.lowFace : range.highFace) : out.position.y;
        return true;
    }

    template<class Phase>
    void follow(const Phase &phase, phys_state &out, phys_report *report) const {
        const double R = m_scene.radius;
        const Place place = phase.placeAt(m_dt);
        out.position = {m_position.x + place.way.x, m_position.y + place.way.y, m_position.z};
        out.velocity = {place.velocity.x, place.velocity.y, 0.0};
        out.spin = fromVec(place.spin);
        if (isRigid()) { // to the last bit
            const Vec3 rolls = rollingSpin(inPlane(place.velocity), R);
            out.spin = {rolls.x, rolls.y, place.spin.z};
        }
        std::copy(std::begin(m_in.orientation), std::end(m_in.orientation), out.orientation);
        if (m_params.options & PHYS_OPTION_ORIENTATION) turn(out.orientation, phase, m_dt);
        out.flags = m_scene.isOut(out.position) ? PHYS_OUT : 0;
        if (!report) return;
        Reporter reporter(report, m_in.time);
        reporter.substeps(1, 0);
        const double given = glm::dot(toVec(m_in.spin), toVec(m_in.spin));
        if (!isRigid()) reporter.lostSlip(0.2 * R * R * (given - glm::dot(m_spin, m_spin)));
    }

    const Scene &m_scene;
    const FloorRegion &m_region;
    const phys_params &m_params;
    const phys_state &m_in;
    double m_dt; ///< s
    Vec3 m_position, m_velocity, m_spin;
    Vec3 m_level;      ///< gravity along the floor, m/s^2
    double m_pressure; ///< gravity into it, m/s^2
};

} // namespace

bool rollUndisturbed(const Scene &scene, FloorRegions &regions, const phys_params &params, double dt,
                     const phys_state &in, phys_state &out, phys_report *report) {
    if (in.velocity.z != 0.0 || !(params.gravity.z < 0.0) || !(dt > 0.0)) return false;
    if (params.options & PHYS_OPTION_ALL_STAGES) return false;
    const FloorRegion *region = regions.around(in.position, in.velocity.x == 0.0 || in.velocity.y == 0.0);
    return region && Undisturbed(scene, *region, params, dt, in).run(out, report);
}

} // namespace phys
