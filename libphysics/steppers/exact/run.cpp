// SPDX-License-Identifier: MIT
#include "run.h"

#include "base/error.h"
#include "base/orientation.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// More events than this in one call end it with an error: only a ball caught between walls gets there.
constexpr uint32_t kEventCap = 1'000'000;

/// And so do more than this at one moment: at that pace the step wouldn't come to its end.
constexpr uint32_t kMomentCap = 1'000;

} // namespace

Run::Run(const Board &board, Sweep &sweep, const phys_params &params, double dt, const phys_state &in,
         phys_report *report, phys_error *err)
    : m_board(board)
    , m_sweep(sweep)
    , m_params(params)
    , m_report(report, in.time)
    , m_err(err)
    , m_ball{toVec(in.position), toVec(in.velocity), toVec(in.spin), false}
    , m_left(dt) {
    std::copy(std::begin(in.orientation), std::end(in.orientation), m_orientation);
    m_sweep.begin();
}

phys_status Run::advance(phys_state &out) {
    m_report.substeps(1, 0);
    enter();
    if (glide()) {
        leave(out);
        return PHYS_OK;
    }
    if (const phys_status status = pushOut()) return status;
    if (const phys_status status = resolve()) return status;
    Pace pace(m_left);
    while (m_left > 0.0) {
        if (const phys_status status = keep(pace)) return status;
        m_meets = false;
        const double before = m_left;
        if (const phys_status status = phase()) return status;
        if (m_sweep.isGivenUp()) {
            return fail(m_err, PHYS_ERROR_EVENT_CAP,
                        "the next contact isn't found in %u looks at walls, %.9g s before the step's end",
                        Sweep::kMostLooks, before);
        }
        // What a phase met at the very end of the step is resolved in this step.
        if (m_left == 0.0 && !m_meets) break;
        if (const phys_status status = resolve()) return status;
    }
    // Sums of what is finite are finite; a NaN would be a mistake in here and must not get out.
    const Vec3 sum = m_ball.position + m_ball.velocity + m_ball.spin;
    if (!std::isfinite(sum.x + sum.y + sum.z)) {
        return fail(m_err, PHYS_ERROR_INTERNAL, "the step's result isn't a number");
    }
    leave(out);
    return PHYS_OK;
}

/// Refuses a step that doesn't come to its end, or not in any time worth waiting for.
phys_status Run::keep(Pace &pace) {
    if (pace.momentStart - m_left > pace.moment) {
        pace.momentStart = m_left;
        pace.eventsInMoment = 0;
    }
    if (++pace.eventsInMoment > kMomentCap) {
        return fail(m_err, PHYS_ERROR_EVENT_CAP, "more than %u events at one moment, %.9g s before the step's end",
                    kMomentCap, m_left);
    }
    if (++pace.events > kEventCap) {
        return fail(m_err, PHYS_ERROR_EVENT_CAP, "more than %u events in one step, %.9g s of it still to go", kEventCap,
                    m_left);
    }
    return PHYS_OK;
}

/// A given state may lie anywhere: on the floor, in it or in the air.
void Run::enter() {
    const Scene &scene = m_board.scene();
    Vec3 &p = m_ball.position;
    const bool overFloor = scene.hasFloor && scene.overFloor(p.x, p.y);
    const bool atHeight = std::abs(p.z - scene.supportedZ) <= m_board.tolerance();
    // In the floor without moving down: pushed up. A ball that moves down there has fallen off the floor's edge.
    const bool inFloor = p.z < scene.supportedZ && p.z > scene.floorTop && m_ball.velocity.z >= 0.0;
    if (overFloor && inFloor && !atHeight) {
        m_report.penetration(scene.supportedZ - p.z);
        p.z = scene.supportedZ;
    }
    const bool pressed = m_params.gravity.z < 0.0; // one that is pulled off isn't carried
    m_ball.supported = overFloor && (atHeight || inFloor) && pressed && m_ball.velocity.z == 0.0;
    if (!m_ball.supported) return;
    p.z = scene.supportedZ;
    if (isRolling()) followVelocity();
}

/// Out of the solids that the given state lies in: model.md 5.7.
phys_status Run::pushOut() {
    Vec3 &p = m_ball.position;
    double deepest = 0.0;
    if (!m_board.pushOut(p, m_ball.supported, deepest)) {
        return fail(m_err, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is wedged where it doesn't fit", p.x, p.y,
                    p.z);
    }
    m_report.penetration(deepest);
    return PHYS_OK;
}

void Run::leave(phys_state &out) {
    const phys_box &bounds = m_board.scene().bounds;
    const Vec3 &p = m_ball.position;
    out.position = fromVec(p);
    out.velocity = fromVec(m_ball.velocity);
    out.spin = fromVec(m_ball.spin);
    std::copy(std::begin(m_orientation), std::end(m_orientation), out.orientation);
    const bool isOut = p.x < bounds.min.x || p.x > bounds.max.x || p.y < bounds.min.y || p.y > bounds.max.y;
    out.flags = (isAtRest() ? PHYS_AT_REST : 0) | (m_ball.supported ? 0 : PHYS_AIRBORNE) | (isOut ? PHYS_OUT : 0) |
                (m_ball.supported && slipVelocity() != Vec2(0.0) ? PHYS_SLIPPING : 0);
}

void Run::spend(double t) {
    m_elapsed += t;
    m_left = t >= m_left ? 0.0 : m_left - t;
}

/// Rolling model: the spin of a supported ball is not a state of its own. What a given spin differs from it counts as
/// lost to slip, of either sign.
void Run::followVelocity() {
    const double R = m_board.radius();
    const Vec3 spin = rollingSpin(inPlane(m_ball.velocity), R);
    m_report.lostSlip(0.2 * R * R * (glm::dot(m_ball.spin, m_ball.spin) - glm::dot(spin, spin)));
    m_ball.spin = spin;
}

void Run::turn(const Vec3 &by) {
    if (m_params.options & PHYS_OPTION_ORIENTATION) rotate(m_orientation, by);
}

void Run::event(uint32_t kind, double before, double after) {
    m_report.event(kind, m_elapsed, m_ball.position, Vec3(0.0), before, after, PHYS_NO_BOX);
}

void Run::contactEvent(uint32_t kind, const Touch &touch, double before, double after) {
    if (!m_report.wanted()) return;
    m_report.event(kind, m_elapsed, touch.point, touch.normal, before, after,
                   m_board.scene().givenSolid(touch.solid, touch.point));
}

phys_status Run::refuse(const char *what, const Touch &touch) const {
    return fail(m_err, PHYS_ERROR_UNSUPPORTED, "box %u: %s, which stepper 'exact' can't follow",
                m_board.scene().givenSolid(touch.solid, touch.point), what);
}

} // namespace phys
