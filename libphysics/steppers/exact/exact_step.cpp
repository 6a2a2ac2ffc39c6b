// SPDX-License-Identifier: MIT
#include "exact/exact_step.h"

#include "base/error.h"
#include "contact/held.h"
#include "contact/push_out.h"
#include "exact/turning.h"

#include <algorithm>
#include <cmath>

namespace phys {

ExactStep::ExactStep(const Scene &scene, FloorRegions &regions, const phys_params &params, double dt,
                     const phys_state &in, phys_report *report, phys_error *err)
    : m_scene(scene)
    , m_regions(regions)
    , m_params(params)
    , m_setting{scene, params}
    , m_report(report, in.time)
    , m_err(err)
    , m_left(dt)
    , m_position(toVec(in.position))
    , m_motion{toVec(in.velocity), toVec(in.spin)} {
    m_setting.sameNormal = sameNormal(scene);
    std::copy(std::begin(in.orientation), std::end(in.orientation), m_orientation);
}

phys_status ExactStep::advance(phys_state &out) {
    m_report.substeps(1, 0);
    if (const phys_status status = pushOut()) return status;
    if (const phys_status status = followEvents()) return status;
    if (const phys_status status = checkWork()) return status;
    const Vec3 sum = m_position + m_motion.velocity + m_motion.spin;
    if (!std::isfinite(sum.x + sum.y + sum.z)) {
        return fail(m_err, PHYS_ERROR_INTERNAL, "the step's result isn't a number");
    }
    leave(out);
    return PHYS_OK;
}

/// The loop of model.md 8.1.
phys_status ExactStep::followEvents() {
    resolve();
    skipBounces();
    Phase phase(Uniform{m_motion.velocity, Vec3(0.0), m_motion.spin, Vec3(0.0)});
    while (m_left > 0.0) {
        m_work.add(Work::kEvent);
        if (const phys_status status = checkWork()) return status;
        if (const phys_status status = choose(phase)) return status;
        if (isStill() && restsNow()) break;
        End end;
        std::visit(
            [&](const auto &chosen) {
                Border border;
                end = firstEvent(chosen, border);
                follow(chosen, end, border);
            },
            phase);
        // What a phase met at the very end of the step is resolved in this step.
        if (m_left == 0.0 && end.cause == Cause::time) break;
        resolve();
        skipBounces();
    }
    return PHYS_OK;
}

/// Refuses a step that doesn't come to its end in any time worth waiting for.
phys_status ExactStep::checkWork() const {
    if (!m_work.isTooMuch()) return PHYS_OK;
    return fail(m_err, PHYS_ERROR_EVENT_CAP, "more to compute than %llu in one step, %.9g s of it still to go",
                static_cast<unsigned long long>(Work::kMost), m_left);
}

/// Looks for the region of the floor that the ball is in, and for the boxes that it touches there.
void ExactStep::findGround() {
    if (runsAllStages()) return;
    const Vec3 &v = m_motion.velocity;
    m_region = m_regions.around(fromVec(m_position), v.x == 0.0 || v.y == 0.0);
    if (!m_region) return;
    m_ground.add(m_region->floor);
    for (int axis = 0; axis < 2; ++axis) {
        const FloorRegion::Range &range = m_region->along[axis];
        if (m_position[axis] == range.lowFace) m_ground.add(range.lowBox);
        if (m_position[axis] == range.highFace) m_ground.add(range.highBox);
    }
    m_nearBoxes = m_ground.count();
}

/// Whether the ball stays in its region from now on, unless it leaves a face that it leans on.
bool ExactStep::staysOnGround(double acceleration) const {
    return m_region && m_region->keeps(m_position, m_motion.velocity, m_left, acceleration);
}

/// Out of the boxes that the given state lies in: model.md 5.7.
phys_status ExactStep::pushOut() {
    const double R = m_scene.radius, least = R - m_scene.tolerance;
    findGround();
    if (staysOnGround(glm::length(m_setting.gravity()))) return PHYS_OK;
    const double speed = glm::length(m_motion.velocity);
    m_openWay = m_left * (speed + m_left * glm::length(m_setting.gravity()));
    const double reach = R * (1.0 + 1e-9) + m_scene.tolerance + m_openWay;
    bool isOutside = true;
    uint32_t near = 0;
    visitNear(m_scene, m_position, R, [&](const phys_box &box, uint32_t) {
        const double square = squaredDistance(box, m_position);
        isOutside = isOutside && square >= least * least;
        near += square <= reach * reach ? 1 : 0;
    });
    m_nearBoxes = m_openWay <= (kCandidateReach - 1.01) * R ? near : kManyBoxes;
    if (isOutside) return PHYS_OK;
    m_nearBoxes = kManyBoxes;
    const PushOut pushed = phys::pushOut(m_scene, m_position, m_work);
    m_report.penetration(pushed.depth);
    if (pushed.isFree) return PHYS_OK;
    if (const phys_status status = checkWork()) return status;
    return fail(m_err, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is wedged where it doesn't fit", m_position.x,
                m_position.y, m_position.z);
}

void ExactStep::leave(phys_state &out) {
    out.position = fromVec(m_position);
    out.velocity = fromVec(m_motion.velocity);
    out.spin = fromVec(m_motion.spin);
    std::copy(std::begin(m_orientation), std::end(m_orientation), out.orientation);
    bool carried = false, slips = false;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (!contactOf(i).isTop || (m_isAnswered ? !isClosed(i) : m_params.gravity.z >= 0.0)) continue;
        carried = true;
        const Vec3 slip = slipAt(moment(), contactOf(i).normal);
        slips = m_setting.isRigid() && m_params.sliding_friction > 0.0 && !isNoSlip(moment(), slip);
    }
    out.flags =
        (isOut(m_scene, out.position) ? PHYS_OUT : 0) | (carried ? 0 : PHYS_AIRBORNE) | (slips ? PHYS_SLIPPING : 0);
    if (!isStill() || m_heldCount == 0) return;
    if (m_isAnswered || respondNow() == PHYS_OK) out.flags |= restsNow() ? PHYS_AT_REST : 0;
}

void ExactStep::event(uint32_t kind, double before, double after) {
    m_report.event(kind, m_elapsed, m_position, Vec3(0.0), before, after, PHYS_NO_BOX);
}

Moment ExactStep::moment() const {
    return {m_motion.velocity, m_motion.spin, m_setting.gravity(), m_scene.radius,
            16.0 * kRounding + 4.0 * m_scene.tolerance / m_scene.radius};
}

// -------------------------------------------------------------------------------------------------------- events

template<>
End ExactStep::ownEnd(const Uniform &phase, double) {
    End end;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        const Reaction &reaction = m_response.reactions[i];
        if (reaction.mode == Mode::slipping && reaction.pressure != 0.0) {
            const Vec3 rate =
                phase.acceleration - m_scene.radius * glm::cross(phase.spinAcceleration, m_held[i].normal);
            const double slows = -glm::dot(rate, reaction.slip);
            if (slows > 0.0) end.cut({glm::dot(reaction.slip, reaction.slip) / slows, Cause::grip, i});
        }
        if (reaction.mode == Mode::sticking && m_held[i].resistance > 0.0 && m_response.rolling != Vec3(0.0)) {
            const double speed = glm::dot(phase.spin, m_response.rolling);
            const double slows = -glm::dot(phase.spinAcceleration, m_response.rolling);
            if (slows > 0.0 && speed > 0.0) end.cut({speed / slows, Cause::stop, i});
        }
    }
    return end;
}

template<>
End ExactStep::ownEnd(const Resisted &phase, double) {
    End end = phase.end();
    isAlone(end.contact);
    return end;
}

template<class P>
End ExactStep::ownEnd(const P &phase, double until) {
    return phase.end(until, m_work);
}

template<class P>
End ExactStep::firstEvent(const P &phase, Border &border) {
    End end{m_left, Cause::time, 0};
    if constexpr (std::is_same_v<P, Uniform>) {
        if (phase.velocity == Vec3(0.0) && restsNow()) return end;
    }
    end.cut(ownEnd(phase, m_left));
    const double acceleration = phase.mostAcceleration();
    const bool meetsNothing = isOpen(acceleration);
    if (meetsNothing && staysOnGround(acceleration)) return end;
    const Outlook around{m_scene, m_position, m_motion, m_contacts, m_work, closedBits()};
    // What is near is looked for first: the ends of long faces are far, if anything is.
    const double length = kFirstWindow * m_scene.radius, speed = glm::length(m_motion.velocity);
    const double soon = meetsNothing ? 0.0 : std::min(end.after, leastTime(length, speed, acceleration));
    double touch = firstTouch(around, phase, 0.0, soon, length);
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (isClosed(i)) cutAtBorder(around, contactOf(i), phase, std::min(end.after, touch), border);
    }
    end.cut({border.after, Cause::border, 0});
    if (!meetsNothing && touch == kNever) touch = firstTouch(around, phase, soon, end.after, 2.0 * length);
    end.cut({touch, Cause::touch, 0});
    return end;
}

/// Whether nothing can be met in this step but what the ball leans on.
bool ExactStep::isOpen(double acceleration) const {
    if (m_elapsed > 0.0 || runsAllStages()) return false;
    const double way = m_left * (glm::length(m_motion.velocity) + 0.5 * m_left * acceleration);
    if (!staysOnGround(acceleration) && way > m_openWay) return false;
    uint32_t closed = 0;
    for (uint32_t i = 0; i < m_heldCount; ++i) closed += isClosed(i) ? 1 : 0;
    return closed == m_nearBoxes;
}

template<class P>
void ExactStep::turn(const P &phase, double t) {
    if (m_params.options & PHYS_OPTION_ORIENTATION) phys::turn(m_orientation, phase, t);
}

template void ExactStep::turn(const Uniform &phase, double t);

template<class P>
void ExactStep::follow(const P &phase, const End &end, const Border &border) {
    const double t = end.after;
    if (m_report.wanted() && t > 0.0) {
        Losses lost;
        if constexpr (!std::is_same_v<P, Uniform>) {
            lost = phase.losses(t);
        } else {
            for (uint32_t i = 0; i < m_heldCount; ++i) {
                const Reaction &reaction = m_response.reactions[i];
                const double R = m_scene.radius;
                const Vec3 middle = phase.spinAt(0.5 * t);
                if (reaction.mode == Mode::slipping || reaction.mode == Mode::starting) {
                    const Vec3 v = phase.at(0.5 * t).velocity;
                    const Vec3 u = v - R * glm::cross(middle, m_held[i].normal);
                    lost.slip += m_held[i].friction * reaction.pressure * t * std::abs(glm::dot(u, reaction.direction));
                }
                if (reaction.mode == Mode::sticking) {
                    lost.rolling += m_held[i].resistance * reaction.pressure * R * t *
                                    std::abs(glm::dot(middle, m_response.rolling));
                }
            }
        }
        m_report.lostSlip(lost.slip);
        m_report.lostRolling(lost.rolling);
    }
    if (t > 0.0) { // of no time, series whose terms are beyond all numbers say nothing
        turn(phase, t);
        const Place place = phase.placeAt(t);
        m_position += place.way;
        m_motion = {place.velocity, place.spin};
    }
    // Not waited for where the ball's velocity changes meanwhile by more than the speed that vanishes.
    const bool waits = end.rest > 0.0 && end.rest * phase.mostAcceleration() <= 16.0 * kSlipEnds * speedScale(moment());
    const double passed = std::min(t + (waits ? end.rest : 0.0), m_left);
    m_elapsed += passed;
    m_left -= passed;
    // Before normals are turned: a slip that has ended would begin again at a place further round an edge.
    if (passed > t && end.cause == Cause::grip) m_position += (passed - t) * m_motion.velocity;
    settle(end, border);
}

/// What the end of a phase makes exact.
void ExactStep::settle(const End &end, const Border &border) {
    const double before = glm::length(m_motion.velocity);
    turnNormals();
    if (end.cause == Cause::stop) {
        const Vec3 n = m_held[end.contact].normal;
        event(PHYS_EVENT_STOP, before, 0.0);
        m_motion.velocity = Vec3(0.0);
        m_motion.spin = glm::dot(m_motion.spin, n) * n;
    }
    if (end.cause == Cause::grip) {
        stick(end.contact, kNever);
        if (contactOf(end.contact).isTop) event(PHYS_EVENT_ROLL, before, glm::length(m_motion.velocity));
    }
    bool holds = end.cause == Cause::stop;
    for (uint32_t i = 0; i < m_heldCount; ++i) holds = holds || sticks(i, end);
    const double rounding = holds ? 4e-13 * speedScale(moment()) : 0.0;
    if (holds) clearSlips(end, rounding);
    if (end.cause != Cause::time || !restsNow()) keepContacts();
    for (uint32_t i = 0; i < m_heldCount && holds; ++i) {
        if (sticks(i, end) && contactOf(i).isTop) rollOn(i, rounding);
    }
    if (end.cause == Cause::border) m_position[border.axis] = border.coordinate;
}

/// Nothing but rounding is left of a slip at what sticks, and of a velocity that ends with it.
void ExactStep::clearSlips(const End &end, double rounding) {
    bool isStill = false;
    for (int sweep = 0; sweep < 4 && !isStill; ++sweep) {
        isStill = true;
        for (uint32_t i = 0; i < m_heldCount; ++i) {
            if (sticks(i, end) && !contactOf(i).isTop && stick(i, rounding)) isStill = false;
        }
    }
    if (end.cause != Cause::grip && end.cause != Cause::stop) return;
    if (glm::length(m_motion.velocity) <= rounding) m_motion.velocity = Vec3(0.0);
    if (m_scene.radius * glm::length(m_motion.spin) <= rounding) m_motion.spin = Vec3(0.0);
}

/// To where the phase has led round edges and corners.
void ExactStep::turnNormals() {
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        const Contact &contact = contactOf(i);
        if (contact.isFace() || !isClosed(i)) continue;
        const phys_box &box = m_scene.boxes[contact.box];
        Vec3 away(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const int side = contact.sides[axis];
            if (side != 0) away[axis] = m_position[axis] - (side > 0 ? (&box.max.x)[axis] : (&box.min.x)[axis]);
        }
        m_held[i].normal = hat(away);
    }
}

/// Lasting contacts are kept at the radius, and nothing is left of a velocity across them.
void ExactStep::keepContacts() {
    const double R = m_scene.radius;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (!isClosed(i)) continue;
        const Contact &contact = contactOf(i);
        const phys_box &box = m_scene.boxes[contact.box];
        const Vec3 &n = m_held[i].normal;
        const double speed = glm::dot(m_motion.velocity, n);
        for (int axis = 0; axis < 3; ++axis) {
            const int side = contact.sides[axis];
            if (side == 0) continue;
            m_position[axis] = (side > 0 ? (&box.max.x)[axis] : (&box.min.x)[axis]) + R * n[axis];
            if (contact.isFace()) m_motion.velocity[axis] = 0.0;
            for (uint32_t j = 0; j < i && contact.isFace(); ++j) { // amid two walls, as takeFaces does
                const Contact &other = contactOf(j);
                if (!isClosed(j) || !other.isFace() || other.sides[axis] != -side) continue;
                m_position[axis] = 0.5 * (m_position[axis] + other.point[axis] - side * R);
            }
        }
        if (!contact.isFace()) m_motion.velocity -= speed * n;
    }
}

/// Whether friction holds the ball at contact i once the phase has ended.
bool ExactStep::sticks(uint32_t i, const End &end) const {
    const Mode mode = m_response.reactions[i].mode;
    const bool rubs = m_held[i].friction > 0.0 && !m_held[i].isGlued;
    return rubs && (mode == Mode::sticking || (mode == Mode::slipping && end.cause == Cause::grip));
}

/// On a floor: gives the ball the spin that belongs to its velocity to the last bit, if that is no more than rounding.
void ExactStep::rollOn(uint32_t i, double rounding) {
    if (glm::length(slipAt(moment(), m_held[i].normal)) > rounding) return;
    const Vec3 rolls = rollingSpin(inPlane(m_motion.velocity), m_scene.radius);
    m_motion.spin = {rolls.x, rolls.y, m_motion.spin.z};
}

/// Ends the slip at a contact by an impulse of its friction, if it is no more than `most`. False if there was nothing
/// to end.
bool ExactStep::stick(uint32_t i, double most) {
    const Held &held = m_held[i];
    const double R = m_scene.radius;
    const Vec3 slip = slipAt(moment(), held.normal);
    if (slip == Vec3(0.0) || glm::length(slip) > most) return false;
    if (contactOf(i).isTop) {
        // On a floor: the spin that belongs to the velocity to the last bit.
        m_motion.velocity -= 2.0 / 7.0 * Vec3(slip.x, slip.y, 0.0);
        const Vec3 rolls = rollingSpin(inPlane(m_motion.velocity), R);
        m_motion.spin = {rolls.x, rolls.y, m_motion.spin.z};
        return true;
    }
    m_motion.velocity -= 2.0 / 7.0 * slip;
    m_motion.spin += 5.0 / 7.0 / R * glm::cross(held.normal, slip);
    return true;
}

} // namespace phys