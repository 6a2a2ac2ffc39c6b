// SPDX-License-Identifier: MIT
#include "exact/exact_step.h"

#include "base/error.h"
#include "contact/held.h"
#include "contact/push_out.h"
#include "phases/turning.h"

#include <algorithm>
#include <cmath>

namespace phys {

ExactStep::ExactStep(const Scene &scene, FloorRegions &regions, const phys_params &params, double dt,
                     const phys_state &in, phys_report *report, phys_error *err)
    : m_ball(scene, params, dt, in, report, err)
    , m_ground(m_ball, regions) {}

phys_status ExactStep::advance(phys_state &out) {
    m_ball.report.substeps(1, 0);
    if (const phys_status status = pushOut()) return status;
    if (const phys_status status = followEvents()) return status;
    if (const phys_status status = m_ball.checkWork()) return status;
    const Vec3 sum = m_ball.position + m_ball.motion.velocity + m_ball.motion.spin;
    if (!std::isfinite(sum.x + sum.y + sum.z)) {
        return fail(m_ball.error, PHYS_ERROR_INTERNAL, "the step's result isn't a number");
    }
    leave(out);
    return PHYS_OK;
}

/// The loop of model.md 8.1.
phys_status ExactStep::followEvents() {
    resolveMoment();
    Phase phase(Uniform{m_ball.motion.velocity, Vec3(0.0), m_ball.motion.spin, Vec3(0.0)});
    while (m_ball.left > 0.0) {
        m_ball.work.add(Work::kEvent);
        if (const phys_status status = m_ball.checkWork()) return status;
        if (const phys_status status = choose(phase)) return status;
        if (m_ball.isStill() && restsNow()) break;
        End end;
        std::visit(
            [&](const auto &chosen) {
                Border border;
                end = firstEvent(chosen, border);
                follow(chosen, end, border);
            },
            phase);
        // What a phase met at the very end of the step is resolved in this step.
        if (m_ball.left == 0.0 && end.cause == Cause::time) break;
        resolveMoment();
    }
    return PHYS_OK;
}

/// Takes the impacts of the moment, and many more at once.
void ExactStep::resolveMoment() {
    m_isAnswered = false;
    resolve(m_ground, m_ball, m_touching);
    skipBounces(m_ground, m_ball, m_touching);
}

/// Out of the boxes that the given state lies in: model.md 5.7.
phys_status ExactStep::pushOut() {
    if (m_ground.keeps(m_ball, glm::length(m_ball.setting.gravity())) || m_ground.lookAround(m_ball)) return PHYS_OK;
    const PushOut pushed = phys::pushOut(m_ball.scene(), m_ball.position, m_ball.work);
    m_ball.report.penetration(pushed.depth);
    if (pushed.isFree) return PHYS_OK;
    if (const phys_status status = m_ball.checkWork()) return status;
    return fail(m_ball.error, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is wedged where it doesn't fit",
                m_ball.position.x, m_ball.position.y, m_ball.position.z);
}

void ExactStep::leave(phys_state &out) {
    out.position = fromVec(m_ball.position);
    out.velocity = fromVec(m_ball.motion.velocity);
    out.spin = fromVec(m_ball.motion.spin);
    std::copy(std::begin(m_ball.orientation), std::end(m_ball.orientation), out.orientation);
    bool carried = false, slips = false;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (!m_touching.contactOf(i).isTop || (m_isAnswered ? !isClosed(i) : m_ball.params().gravity.z >= 0.0))
            continue;
        carried = true;
        const Vec3 slip = slipAt(m_ball.moment(), m_touching.contactOf(i).normal);
        slips = m_ball.setting.isRigid() && m_ball.params().sliding_friction > 0.0 && !isNoSlip(m_ball.moment(), slip);
    }
    out.flags = (isOut(m_ball.scene(), out.position) ? PHYS_OUT : 0) | (carried ? 0 : PHYS_AIRBORNE) |
                (slips ? PHYS_SLIPPING : 0);
    if (!m_ball.isStill() || m_touching.count() == 0) return;
    if (m_isAnswered || respondNow() == PHYS_OK) out.flags |= restsNow() ? PHYS_AT_REST : 0;
}

// -------------------------------------------------------------------------------------------------------- events

template<>
End ExactStep::ownEnd(const Uniform &phase, double) {
    End end;
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        const Reaction &reaction = m_response.reactions[i];
        if (reaction.mode == Mode::slipping && reaction.pressure != 0.0) {
            const Vec3 rate =
                phase.acceleration - m_ball.radius() * glm::cross(phase.spinAcceleration, m_touching.held(i).normal);
            const double slows = -glm::dot(rate, reaction.slip);
            if (slows > 0.0) end.cut({glm::dot(reaction.slip, reaction.slip) / slows, Cause::grip, i});
        }
        if (reaction.mode == Mode::sticking && m_touching.held(i).resistance > 0.0 && m_response.rolling != Vec3(0.0)) {
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
    return phase.end(until, m_ball.work);
}

template<class P>
End ExactStep::firstEvent(const P &phase, Border &border) {
    End end{m_ball.left, Cause::time, 0};
    if constexpr (std::is_same_v<P, Uniform>) {
        if (phase.velocity == Vec3(0.0) && restsNow()) return end;
    }
    end.cut(ownEnd(phase, m_ball.left));
    const double acceleration = phase.mostAcceleration();
    uint32_t closed = 0;
    for (uint32_t i = 0; i < m_touching.count(); ++i) closed += isClosed(i) ? 1 : 0;
    const bool meetsNothing = m_ground.isOpen(m_ball, closed, acceleration);
    if (meetsNothing && m_ground.keeps(m_ball, acceleration)) return end;
    const Outlook around{m_ball.scene(),      m_ball.position, m_ball.motion,
                         m_touching.contacts, m_ball.work,     closedBits()};
    // What is near is looked for first: the ends of long faces are far, if anything is.
    const double length = kFirstWindow * m_ball.radius(), speed = glm::length(m_ball.motion.velocity);
    const double soon = meetsNothing ? 0.0 : std::min(end.after, leastTime(length, speed, acceleration));
    double touch = firstTouch(around, phase, 0.0, soon, length);
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (isClosed(i)) cutAtBorder(around, m_touching.contactOf(i), phase, std::min(end.after, touch), border);
    }
    end.cut({border.after, Cause::border, 0});
    if (!meetsNothing && touch == kNever) touch = firstTouch(around, phase, soon, end.after, 2.0 * length);
    end.cut({touch, Cause::touch, 0});
    return end;
}

template<class P>
void ExactStep::follow(const P &phase, const End &end, const Border &border) {
    const double t = end.after;
    if (m_ball.report.wanted() && t > 0.0) {
        Losses lost;
        if constexpr (!std::is_same_v<P, Uniform>) {
            lost = phase.losses(t);
        } else {
            for (uint32_t i = 0; i < m_touching.count(); ++i) {
                const Reaction &reaction = m_response.reactions[i];
                const double R = m_ball.radius();
                const Vec3 middle = phase.spinAt(0.5 * t);
                if (reaction.mode == Mode::slipping || reaction.mode == Mode::starting) {
                    const Vec3 v = phase.at(0.5 * t).velocity;
                    const Vec3 u = v - R * glm::cross(middle, m_touching.held(i).normal);
                    lost.slip +=
                        m_touching.held(i).friction * reaction.pressure * t * std::abs(glm::dot(u, reaction.direction));
                }
                if (reaction.mode == Mode::sticking) {
                    lost.rolling += m_touching.held(i).resistance * reaction.pressure * R * t *
                                    std::abs(glm::dot(middle, m_response.rolling));
                }
            }
        }
        m_ball.report.lostSlip(lost.slip);
        m_ball.report.lostRolling(lost.rolling);
    }
    if (t > 0.0) { // of no time, series whose terms are beyond all numbers say nothing
        m_ball.turn(phase, t);
        const Place place = phase.placeAt(t);
        m_ball.position += place.way;
        m_ball.motion = {place.velocity, place.spin};
    }
    // Not waited for where the ball's velocity changes meanwhile by more than the speed that vanishes.
    const bool waits =
        end.rest > 0.0 && end.rest * phase.mostAcceleration() <= 16.0 * kSlipEnds * speedScale(m_ball.moment());
    const double passed = std::min(t + (waits ? end.rest : 0.0), m_ball.left);
    m_ball.pass(passed);
    // Before normals are turned: a slip that has ended would begin again at a place further round an edge.
    if (passed > t && end.cause == Cause::grip) m_ball.position += (passed - t) * m_ball.motion.velocity;
    settle(end, border);
}

/// What the end of a phase makes exact.
void ExactStep::settle(const End &end, const Border &border) {
    const double before = glm::length(m_ball.motion.velocity);
    turnNormals();
    if (end.cause == Cause::stop) {
        const Vec3 n = m_touching.held(end.contact).normal;
        m_ball.event(PHYS_EVENT_STOP, before, 0.0);
        m_ball.motion.velocity = Vec3(0.0);
        m_ball.motion.spin = glm::dot(m_ball.motion.spin, n) * n;
    }
    if (end.cause == Cause::grip) {
        stick(end.contact, kNever);
        if (m_touching.contactOf(end.contact).isTop)
            m_ball.event(PHYS_EVENT_ROLL, before, glm::length(m_ball.motion.velocity));
    }
    bool holds = end.cause == Cause::stop;
    for (uint32_t i = 0; i < m_touching.count(); ++i) holds = holds || sticks(i, end);
    const double rounding = holds ? 4e-13 * speedScale(m_ball.moment()) : 0.0;
    if (holds) clearSlips(end, rounding);
    if (end.cause != Cause::time || !restsNow()) keepContacts();
    for (uint32_t i = 0; i < m_touching.count() && holds; ++i) {
        if (sticks(i, end) && m_touching.contactOf(i).isTop) rollOn(i, rounding);
    }
    if (end.cause == Cause::border) m_ball.position[border.axis] = border.coordinate;
}

/// Nothing but rounding is left of a slip at what sticks, and of a velocity that ends with it.
void ExactStep::clearSlips(const End &end, double rounding) {
    bool isStill = false;
    for (int sweep = 0; sweep < 4 && !isStill; ++sweep) {
        isStill = true;
        for (uint32_t i = 0; i < m_touching.count(); ++i) {
            if (sticks(i, end) && !m_touching.contactOf(i).isTop && stick(i, rounding)) isStill = false;
        }
    }
    if (end.cause != Cause::grip && end.cause != Cause::stop) return;
    if (glm::length(m_ball.motion.velocity) <= rounding) m_ball.motion.velocity = Vec3(0.0);
    if (m_ball.radius() * glm::length(m_ball.motion.spin) <= rounding) m_ball.motion.spin = Vec3(0.0);
}

/// To where the phase has led round edges and corners.
void ExactStep::turnNormals() {
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        const Contact &contact = m_touching.contactOf(i);
        if (contact.isFace() || !isClosed(i)) continue;
        const phys_box &box = m_ball.scene().boxes[contact.box];
        Vec3 away(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const int side = contact.sides[axis];
            if (side != 0) away[axis] = m_ball.position[axis] - (side > 0 ? (&box.max.x)[axis] : (&box.min.x)[axis]);
        }
        m_touching.held(i).normal = hat(away);
    }
}

/// Lasting contacts are kept at the radius, and nothing is left of a velocity across them.
void ExactStep::keepContacts() {
    const double R = m_ball.radius();
    for (uint32_t i = 0; i < m_touching.count(); ++i) {
        if (!isClosed(i)) continue;
        const Contact &contact = m_touching.contactOf(i);
        const phys_box &box = m_ball.scene().boxes[contact.box];
        const Vec3 &n = m_touching.held(i).normal;
        const double speed = glm::dot(m_ball.motion.velocity, n);
        for (int axis = 0; axis < 3; ++axis) {
            const int side = contact.sides[axis];
            if (side == 0) continue;
            m_ball.position[axis] = (side > 0 ? (&box.max.x)[axis] : (&box.min.x)[axis]) + R * n[axis];
            if (contact.isFace()) m_ball.motion.velocity[axis] = 0.0;
            for (uint32_t j = 0; j < i && contact.isFace(); ++j) { // amid two walls, as takeFaces does
                const Contact &other = m_touching.contactOf(j);
                if (!isClosed(j) || !other.isFace() || other.sides[axis] != -side) continue;
                m_ball.position[axis] = 0.5 * (m_ball.position[axis] + other.point[axis] - side * R);
            }
        }
        if (!contact.isFace()) m_ball.motion.velocity -= speed * n;
    }
}

/// Whether friction holds the ball at contact i once the phase has ended.
bool ExactStep::sticks(uint32_t i, const End &end) const {
    const Mode mode = m_response.reactions[i].mode;
    const bool rubs = m_touching.held(i).friction > 0.0 && !m_touching.held(i).isGlued;
    return rubs && (mode == Mode::sticking || (mode == Mode::slipping && end.cause == Cause::grip));
}

/// On a floor: gives the ball the spin that belongs to its velocity to the last bit, if that is no more than rounding.
void ExactStep::rollOn(uint32_t i, double rounding) {
    if (glm::length(slipAt(m_ball.moment(), m_touching.held(i).normal)) > rounding) return;
    const Vec3 rolls = rollingSpin(inPlane(m_ball.motion.velocity), m_ball.radius());
    m_ball.motion.spin = {rolls.x, rolls.y, m_ball.motion.spin.z};
}

/// Ends the slip at a contact by an impulse of its friction, if it is no more than `most`. False if there was nothing
/// to end.
bool ExactStep::stick(uint32_t i, double most) {
    const Held &held = m_touching.held(i);
    const double R = m_ball.radius();
    const Vec3 slip = slipAt(m_ball.moment(), held.normal);
    if (slip == Vec3(0.0) || glm::length(slip) > most) return false;
    if (m_touching.contactOf(i).isTop) {
        // On a floor: the spin that belongs to the velocity to the last bit.
        m_ball.motion.velocity -= 2.0 / 7.0 * Vec3(slip.x, slip.y, 0.0);
        const Vec3 rolls = rollingSpin(inPlane(m_ball.motion.velocity), R);
        m_ball.motion.spin = {rolls.x, rolls.y, m_ball.motion.spin.z};
        return true;
    }
    m_ball.motion.velocity -= 2.0 / 7.0 * slip;
    m_ball.motion.spin += 5.0 / 7.0 / R * glm::cross(held.normal, slip);
    return true;
}

} // namespace phys