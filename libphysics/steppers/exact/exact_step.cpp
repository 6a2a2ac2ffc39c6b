// SPDX-License-Identifier: MIT
#include "exact/exact_step.h"

#include "base/error.h"
#include "base/orientation.h"
#include "contact/impact.h"
#include "contact/push_out.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// More events than this in one call end it with an error: only a ball caught between walls gets there. A phase by
/// series counts for as many as it takes the time of.
constexpr uint32_t kEventCap = 120'000;
constexpr uint32_t kSeriesCost = 60;

/// And so do more than this at one moment: at that pace the step wouldn't come to its end.
constexpr uint32_t kMomentCap = 1'000;

/// Rounds of impacts at one moment: each ends bounces that are none, which may drive the ball into another contact.
constexpr int kMostRounds = 16;

/// Bounces that rise no higher than this, in radii, are the last of infinitely many: model.md 6.4.
constexpr double kLastBounce = 1e-13;
/// Where what is between two bounces has another law than what comes after the last: the error is of first order there.
constexpr double kLastHop = 1e-26;

/// Sine of the angle between normals, or of one and a plane, below which they are parallel but for rounding.
constexpr double kParallel = 1e-12;

/// But with a restitution above this the bounces down there would never end.
constexpr double kSlowDecay = 0.95;

Vec3 hat(Vec3 v) {
    const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (most == 0.0) return Vec3(0.0);
    if (most < 1e-100) v /= most; // whose squares underflow
    return v / glm::length(v);
}

/// Whether b points along a line that a has, either way, but for rounding.
bool isCollinear(const Vec3 &a, const Vec3 &b) { return glm::length(glm::cross(hat(a), hat(b))) <= 4.0 * kRounding; }

} // namespace

ExactStep::ExactStep(const Scene &scene, const phys_params &params, double dt, const phys_state &in,
                     phys_report *report, phys_error *err)
    : m_scene(scene)
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
    if (const phys_status status = resolve()) return status;
    Pace pace(m_left);
    Phase phase(Uniform{m_motion.velocity, Vec3(0.0), m_motion.spin, Vec3(0.0)});
    while (m_left > 0.0) {
        if (const phys_status status = keep(pace)) return status;
        if (const phys_status status = choose(phase)) return status;
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
        if (const phys_status status = resolve()) return status;
    }
    const Vec3 sum = m_position + m_motion.velocity + m_motion.spin;
    if (!std::isfinite(sum.x + sum.y + sum.z)) {
        return fail(m_err, PHYS_ERROR_INTERNAL, "the step's result isn't a number");
    }
    leave(out);
    return PHYS_OK;
}

/// Refuses a step that doesn't come to its end, or not in any time worth waiting for.
phys_status ExactStep::keep(Pace &pace) {
    if (pace.momentStart - m_left > pace.moment) {
        pace.momentStart = m_left;
        pace.eventsInMoment = 0;
    }
    if (++pace.eventsInMoment > kMomentCap) {
        return fail(m_err, PHYS_ERROR_EVENT_CAP, "more than %u events at one moment, %.9g s before the step's end",
                    kMomentCap, m_left);
    }
    pace.events += m_isSeries ? kSeriesCost : 1;
    if (pace.events > kEventCap) {
        return fail(m_err, PHYS_ERROR_EVENT_CAP, "more than %u events in one step, %.9g s of it still to go", kEventCap,
                    m_left);
    }
    return PHYS_OK;
}

/// Out of the boxes that the given state lies in: model.md 5.7.
phys_status ExactStep::pushOut() {
    const double R = m_scene.radius, least = R - m_scene.tolerance;
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
    const PushOut pushed = phys::pushOut(m_scene, m_position);
    m_report.penetration(pushed.depth);
    if (pushed.isFree) return PHYS_OK;
    return fail(m_err, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is wedged where it doesn't fit", m_position.x,
                m_position.y, m_position.z);
}

void ExactStep::leave(phys_state &out) {
    const phys_box &bounds = m_scene.bounds;
    const Vec3 &p = m_position;
    out.position = fromVec(p);
    out.velocity = fromVec(m_motion.velocity);
    out.spin = fromVec(m_motion.spin);
    std::copy(std::begin(m_orientation), std::end(m_orientation), out.orientation);
    const bool isOut = p.x < bounds.min.x || p.x > bounds.max.x || p.y < bounds.min.y || p.y > bounds.max.y;
    bool carried = false, slips = false;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (!contactOf(i).isTop || (m_isAnswered ? !isClosed(i) : m_params.gravity.z >= 0.0)) continue;
        carried = true;
        const Vec3 slip = slipAt(moment(), contactOf(i).normal);
        slips = m_setting.isRigid() && m_params.sliding_friction > 0.0 && !isNoSlip(moment(), slip);
    }
    out.flags = (isOut ? PHYS_OUT : 0) | (carried ? 0 : PHYS_AIRBORNE) | (slips ? PHYS_SLIPPING : 0);
    if (m_motion.velocity != Vec3(0.0) || m_heldCount == 0) return;
    if (m_isAnswered || respondNow() == PHYS_OK) out.flags |= restsNow() ? PHYS_AT_REST : 0;
}

void ExactStep::event(uint32_t kind, double before, double after) {
    m_report.event(kind, m_elapsed, m_position, Vec3(0.0), before, after, PHYS_NO_BOX);
}

// --------------------------------------------------------------------------------------------- what happens in no time

Moment ExactStep::moment() const {
    return {m_motion.velocity, m_motion.spin, m_setting.gravity(), m_scene.radius,
            16.0 * kRounding + 4.0 * m_scene.tolerance / m_scene.radius};
}

/// Takes all impacts of the moment, and looks at what lasts then.
phys_status ExactStep::resolve() {
    m_isAnswered = false;
    const double speed = glm::length(m_motion.velocity), negligible = negligibleSpeed(m_motion, m_scene.radius);
    touch();
    const bool wasCarried = isCarried(negligible);
    bool hits = false;
    for (int round = 0; round < kMostRounds && collide(negligible); ++round) {
        hits = true;
        // Nothing but rounding is left of a velocity that led straight into what it hit.
        if (glm::length(m_motion.velocity) <= 4.0 * kRounding * speed) m_motion.velocity = Vec3(0.0);
        touch();
        hold(negligible);
    }
    hold(negligible);
    if (collide(negligible)) hold(negligible);
    roll(hits && wasCarried);
    return PHYS_OK;
}

/// Whether a floor carries the ball of the rolling model.
bool ExactStep::isCarried(double negligible) const {
    return std::any_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &contact) {
        return contact.isGlued && std::abs(glm::dot(m_motion.velocity, contact.normal)) <= negligible;
    });
}

void ExactStep::touch() {
    findContacts(m_setting, m_position, m_motion, Vec3(0.0), m_contacts);
    m_contacts.dropHidden(m_scene.tolerance);
}

/// model.md 6.4: what bounces no higher than rounding bounces for the last time.
void ExactStep::endBounces(double negligible) {
    collectHeld(negligible);
    const Vec3 acting = actingAcceleration();
    for (Contact &contact : m_contacts) {
        const double speed = glm::dot(m_motion.velocity, contact.normal);
        if (speed < -negligible && contact.restitution * -speed <= lastBounce(contact, acting)) {
            contact.restitution = 0.0;
        }
    }
}

/// What accelerates the ball if nothing but the lasting contacts pushes.
Vec3 ExactStep::actingAcceleration() const {
    if (m_heldCount == 0) return m_setting.gravity();
    const Response response = respond(moment(), held());
    return response.isFound ? response.acceleration : m_setting.gravity();
}

/// True if anything was hit.
bool ExactStep::collide(double negligible) {
    const bool approaches = std::any_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &contact) {
        return glm::dot(m_motion.velocity, contact.normal) < -negligible;
    });
    if (!approaches) return false;
    endBounces(negligible);
    const Impacts impacts = resolveImpacts(m_contacts, m_scene.radius, m_motion);
    m_report.lostImpact(impacts.lostNormal);
    m_report.lostSlip(impacts.lostSlip);
    m_report.passes(impacts.rounds);
    if (!m_report.wanted()) return true;
    for (uint32_t i = 0; i < m_contacts.count(); ++i) {
        const Contact &contact = m_contacts[i];
        if (impacts.approach[i] >= 0.0) continue;
        m_report.event(contact.isTop ? PHYS_EVENT_LANDING : PHYS_EVENT_IMPACT, m_elapsed, contact.point, contact.normal,
                       impacts.approach[i], std::max(0.0, glm::dot(m_motion.velocity, contact.normal)),
                       m_scene.givenBox(contact.box, contact.point));
    }
    return true;
}

/// Speed after a bounce below which it is the last, model.md 6.4: its height is no more than rounding.
double ExactStep::lastBounce(const Contact &contact, const Vec3 &acting) const {
    const double R = m_scene.radius;
    const double speed = glm::dot(m_motion.velocity, contact.normal);
    const Vec3 round = m_motion.velocity - speed * contact.normal;
    const double back = -(glm::dot(acting, contact.normal) + contact.curving(round, R));
    const bool isUpright = contact.normal.z == 0.0;
    const bool isSmooth = (isUpright && contact.friction == 0.0) || contact.restitution > kSlowDecay;
    return std::sqrt(2.0 * std::max(0.0, back) *
                     (isSmooth ? std::max(m_scene.tolerance, kLastBounce * R) : kLastHop * R));
}

/// The contacts without a velocity across.
void ExactStep::collectHeld(double negligible) {
    m_heldCount = 0;
    for (uint32_t i = 0; i < m_contacts.count(); ++i) {
        if (std::abs(glm::dot(m_motion.velocity, m_contacts[i].normal)) <= negligible) addHeld(i);
    }
}

void ExactStep::addHeld(uint32_t number) {
    if (m_heldCount == kMostHeld) return;
    const Contact &contact = m_contacts[number];
    Held &held = m_held[m_heldCount];
    held.normal = contact.normal;
    held.across = contact.across(Vec3(1.0));
    held.friction = contact.friction;
    held.resistance = contact.isTop ? m_params.rolling_friction : 0.0;
    held.isGlued = contact.isGlued;
    m_lasting[m_heldCount++] = number;
}

/// Ends the bounce of one more contact, rather of one that doesn't drive the ball into another: false if none bounces
/// so low.
bool ExactStep::holdNext(double negligible) {
    const Vec3 acting = actingAcceleration();
    uint32_t next = Contacts::kMost;
    for (uint32_t i = 0; i < m_contacts.count(); ++i) {
        const double speed = glm::dot(m_motion.velocity, m_contacts[i].normal);
        const auto held = m_lasting.begin() + m_heldCount;
        if (std::find(m_lasting.begin(), held, i) != held) continue;
        if (speed < 0.0 || speed > lastBounce(m_contacts[i], acting)) continue;
        const Vec3 left = m_motion.velocity - speed * m_contacts[i].normal;
        const bool isFree = std::none_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &other) {
            return glm::dot(left, other.normal) < -negligible;
        });
        if (isFree || next == Contacts::kMost) next = i;
        if (!isFree) continue;
        m_motion.velocity = left;
        break;
    }
    if (next == Contacts::kMost) return false;
    addHeld(next);
    return true;
}

/// The contacts that last: exactly at the radius, without a velocity across, or with one whose bounce ends at once.
void ExactStep::hold(double negligible) {
    for (Contact &contact : m_contacts) {
        if (!contact.isFace()) continue;
        for (int axis = 0; axis < 3; ++axis) {
            if (contact.sides[axis] != 0) m_position[axis] = contact.point[axis] + contact.sides[axis] * m_scene.radius;
        }
    }
    collectHeld(negligible);
    while (m_heldCount < std::min(m_contacts.count(), kMostHeld) && holdNext(negligible)) {
    }
    project();
}

/// Removes what is left of the velocity across the lasting contacts.
void ExactStep::project() {
    Vec3 &v = m_motion.velocity;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        const Vec3 &n = m_held[i].normal;
        for (uint32_t j = 0; j < i; ++j) {
            const Vec3 line = glm::cross(n, m_held[j].normal);
            if (glm::dot(line, line) < kParallel * kParallel) continue;
            const Vec3 along = hat(line);
            for (uint32_t k = 0; k < j; ++k) {
                if (std::abs(glm::dot(m_held[k].normal, along)) > kParallel) v = Vec3(0.0);
            }
            v = glm::dot(v, along) * along;
        }
        if (contactOf(i).isFace()) {
            for (int axis = 0; axis < 3; ++axis) {
                if (n[axis] != 0.0) v[axis] = 0.0;
            }
        } else {
            v -= glm::dot(v, n) * n;
        }
    }
}

/// Rolling model: the spin of a ball that a floor carries is not a state of its own. What a given spin differs from it
/// counts as lost to slip, of either sign; at an impact of a ball that rolls it is part of what the impact takes.
void ExactStep::roll(bool isImpact) {
    if (m_setting.isRigid() || m_params.gravity.z >= 0.0) return;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (!m_held[i].isGlued) continue;
        const double R = m_scene.radius;
        const Vec3 spin = rollingSpin(inPlane(m_motion.velocity), R);
        const double lost = 0.2 * R * R * (glm::dot(m_motion.spin, m_motion.spin) - glm::dot(spin, spin));
        isImpact ? m_report.lostImpact(lost) : m_report.lostSlip(lost);
        m_motion.spin = spin;
    }
}

// -------------------------------------------------------------------------------------------------------- phases

phys_status ExactStep::respondNow() {
    m_response = respond(moment(), held());
    if (m_response.isFound) return PHYS_OK;
    if (const phys_status status = jam()) return status;
    return PHYS_OK;
}

/// No modes fit: friction drives the reactions beyond all bounds, an impact without a collision. What slips sticks.
phys_status ExactStep::jam() {
    Moment stopped = moment();
    endSlips(stopped, held());
    const double R = m_scene.radius;
    const auto energy = [R](const Vec3 &v, const Vec3 &spin) {
        return 0.5 * glm::dot(v, v) + 0.2 * R * R * glm::dot(spin, spin);
    };
    m_report.lostSlip(energy(m_motion.velocity, m_motion.spin) - energy(stopped.velocity, stopped.spin));
    m_motion = {stopped.velocity, stopped.spin};
    m_response = respond(moment(), held());
    if (m_response.isFound) return PHYS_OK;
    return fail(m_err, PHYS_ERROR_STUCK, "the ball at (%.9g, %.9g, %.9g) is jammed by friction", m_position.x,
                m_position.y, m_position.z);
}

uint32_t ExactStep::closedBits() const {
    uint32_t bits = 0;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (isClosed(i)) bits |= 1U << m_lasting[i];
    }
    return bits;
}

bool ExactStep::restsNow() const {
    if (m_motion.velocity != Vec3(0.0)) return false;
    if (glm::length(m_response.acceleration) > m_response.noise) return false;
    if (glm::length(m_response.spinAcceleration) * m_scene.radius > m_response.noise) return false;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        const Mode mode = m_response.reactions[i].mode;
        if (mode == Mode::slipping || mode == Mode::starting) return false;
    }
    return true;
}

/// Whether all accelerations stay as they are: only faces press, and slips and resistance keep their directions.
bool ExactStep::isUniform() const {
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        const Reaction &reaction = m_response.reactions[i];
        if (reaction.mode == Mode::open) continue;
        if (!contactOf(i).isFace()) return false;
        if (reaction.mode == Mode::slipping) {
            const Vec3 rate =
                m_response.acceleration - m_scene.radius * glm::cross(m_response.spinAcceleration, m_held[i].normal);
            if (!isCollinear(reaction.slip, rate)) return false;
        }
        if (reaction.mode == Mode::sticking && m_held[i].resistance > 0.0 && m_response.rolling != Vec3(0.0)) {
            Vec3 turning = m_response.spinAcceleration;
            turning -= glm::dot(turning, m_held[i].normal) * m_held[i].normal;
            if (!isCollinear(m_response.rolling, turning)) return false;
        }
    }
    return true;
}

/// Whether a single face presses, and which contact that is.
bool ExactStep::isAlone(uint32_t &closed) const {
    closed = kMostHeld;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (!isClosed(i)) continue;
        if (closed != kMostHeld || !contactOf(i).isFace()) return false;
        closed = i;
    }
    return closed != kMostHeld;
}

/// Nothing is left of the velocity of a ball that resistance holds: it was rounding, model.md 14.1.
void ExactStep::stopHeld() {
    if (m_response.rolling != Vec3(0.0) || !isNoSlip(moment(), m_motion.velocity)) return;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (m_response.reactions[i].mode != Mode::sticking || m_held[i].resistance == 0.0) continue;
        const Vec3 &n = m_held[i].normal;
        const Vec3 pivoting = glm::dot(m_motion.spin, n) * n;
        if (!isNoSlip(moment(), m_scene.radius * (m_motion.spin - pivoting))) continue;
        const bool pivots = countSticking() == 1 || !isNoSlip(moment(), m_scene.radius * pivoting);
        m_motion = {Vec3(0.0), pivots ? pivoting : Vec3(0.0)};
    }
}

phys_status ExactStep::choose(Phase &phase) {
    if (const phys_status status = respondNow()) return status;
    m_isAnswered = true;
    stopHeld();
    const Vec3 g = m_setting.gravity();
    uint32_t closed = kMostHeld;
    if (!m_setting.isRigid() && restsNow()) {
        m_report.lostSlip(0.2 * m_scene.radius * m_scene.radius * glm::dot(m_motion.spin, m_motion.spin));
        m_motion.spin = Vec3(0.0);
    }
    if (restsNow()) {
        phase = Uniform{Vec3(0.0), Vec3(0.0), m_motion.spin, Vec3(0.0)};
    } else if (isUniform()) {
        const Vec3 &a = m_response.acceleration, &v = m_motion.velocity;
        phase = Uniform{v, a, m_motion.spin, m_response.spinAcceleration};
    } else if (isAlone(closed)) {
        const Held &face = m_held[closed];
        const Reaction &reaction = m_response.reactions[closed];
        const int axis = face.normal.x != 0.0 ? 0 : face.normal.y != 0.0 ? 1 : 2;
        Vec3 along = g;
        along[axis] = 0.0;
        if (reaction.mode == Mode::slipping) {
            phase = Resisted::slipping(axis, m_motion.velocity, reaction.slip, along, face.friction * reaction.pressure,
                                       m_scene.radius, m_motion.spin, face.normal);
        } else {
            phase = Resisted::rolling(axis, m_motion.velocity, 5.0 / 7.0 * along,
                                      5.0 / 7.0 * (face.resistance * reaction.pressure), m_scene.radius, m_motion.spin,
                                      face.normal);
        }
    } else {
        buildSeries(phase.emplace<Series>());
    }
    m_isSeries = std::holds_alternative<Series>(phase);
    noteContacts();
    return PHYS_OK;
}

/// Series in the unit of time that suits them, with the modes that hold in the moments to come.
void ExactStep::buildSeries(Series &series) {
    const double R = m_scene.radius;
    const double scale = glm::length(m_setting.gravity()) + glm::length(m_response.acceleration) +
                         glm::dot(m_motion.velocity, m_motion.velocity) / R;
    double unit = std::sqrt(R / scale);
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (m_response.reactions[i].mode != Mode::slipping) continue;
        unit = std::min(unit, 4.0 * glm::length(m_response.reactions[i].slip) / scale);
    }
    const double longest = std::max(unit, m_left);
    Excluded excluded;
    uint32_t spent = 0, kept = 0;
    for (int change = 0; change < 8; ++change) {
        bool hasShrunk = false;
        for (int guess = 0; guess < 40; ++guess) {
            Response response = m_response;
            for (uint32_t i = 0; i < m_heldCount; ++i) {
                if (spent >> i & 1U) response.reactions[i].mode = Mode::spent;
            }
            series.build(moment(), held(), response, unit, kept);
            const bool isLong = series.horizon() > unit && unit < longest && !hasShrunk;
            if (series.horizon() >= 0.25 * unit && !isLong) break;
            hasShrunk = !isLong;
            unit = isLong ? std::min(4.0 * unit, longest) : std::max(series.suitableUnit(), 0x1p-8 * unit);
        }
        const uint32_t opening = series.opening() & ~excluded.closed;
        const uint32_t slipping = series.spent() & ~(spent | kept);
        if (!opening && !slipping) return;
        if (!opening && countSticking() == 1) {
            spent |= slipping;
            withoutResistance(slipping);
            continue;
        }
        // Contacts that stick together slip with an acceleration from the start, if at all: their directions are bound.
        excluded.closed |= opening;
        excluded.sticking |= opening ? 0 : slipping;
        const Response changed = respond(moment(), held(), excluded);
        if (changed.isFound) {
            m_response = changed;
            continue;
        }
        excluded.sticking &= ~slipping;
        excluded.closed &= ~opening;
        if (opening) return;
        kept |= slipping;
    }
}

/// A ball that begins to slip rolls no longer, so that nothing resists its rolling.
void ExactStep::withoutResistance(uint32_t slipping) {
    bool resists = false;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (!(slipping >> i & 1U) || m_held[i].resistance == 0.0) continue;
        m_held[i].resistance = 0.0;
        resists = true;
    }
    if (!resists) return;
    const Response free = respond(moment(), held());
    if (free.isFound) m_response = free;
}

uint32_t ExactStep::countSticking() const {
    uint32_t count = 0;
    for (uint32_t i = 0; i < m_heldCount; ++i) count += m_response.reactions[i].mode == Mode::sticking ? 1 : 0;
    return count;
}

/// Reports which contacts begin to last, and which end without an impact.
void ExactStep::noteContacts() {
    if (!m_report.wanted()) return;
    bool supported = false;
    uint32_t wall = PHYS_NO_BOX, place = 0;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (!isClosed(i)) continue;
        if (contactOf(i).isTop) {
            supported = true;
        } else {
            wall = contactOf(i).box;
            place = i;
        }
    }
    const double speed = glm::length(m_motion.velocity);
    if (m_elapsed > 0.0) {
        if (m_supported && !supported) event(PHYS_EVENT_TAKEOFF, speed, speed);
        if (wall != PHYS_NO_BOX && m_wall == PHYS_NO_BOX) {
            const Contact &contact = contactOf(place);
            m_report.event(PHYS_EVENT_CONTACT, m_elapsed, contact.point, contact.normal, speed, speed,
                           m_scene.givenBox(contact.box, contact.point));
        }
        if (wall == PHYS_NO_BOX && m_wall != PHYS_NO_BOX) {
            const Nearest left = nearest(m_scene.boxes[m_wall], m_position);
            m_report.event(PHYS_EVENT_RELEASE, m_elapsed, left.point, left.normal, speed, speed,
                           m_scene.givenBox(m_wall, left.point));
        }
    }
    m_supported = supported;
    m_wall = wall;
}

// -------------------------------------------------------------------------------------------------------- events

template<>
End ExactStep::ownEnd(const Uniform &phase, double) const {
    End end;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        const Reaction &reaction = m_response.reactions[i];
        if (reaction.mode == Mode::slipping) {
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
End ExactStep::ownEnd(const Resisted &phase, double) const {
    End end = phase.end();
    isAlone(end.contact);
    return end;
}

template<>
End ExactStep::ownEnd(const Series &phase, double until) const {
    return phase.end(until);
}

template<class P>
End ExactStep::firstEvent(const P &phase, Border &border) const {
    End end{m_left, Cause::time, 0};
    if constexpr (std::is_same_v<P, Uniform>) {
        if (phase.velocity == Vec3(0.0) && restsNow()) return end;
    }
    end.cut(ownEnd(phase, m_left));
    const Outlook around{m_scene, m_position, m_motion, m_contacts, closedBits()};
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (isClosed(i)) cutAtBorder(around, contactOf(i), phase, end.after, border);
    }
    end.cut({border.after, Cause::border, 0});
    if (isOpen(phase.mostAcceleration())) return end;
    end.cut({firstTouch(around, phase, end.after), Cause::touch, 0});
    return end;
}

/// Whether nothing is near enough to be met in this step but what the ball leans on.
bool ExactStep::isOpen(double acceleration) const {
    if (m_elapsed > 0.0 || m_left * (glm::length(m_motion.velocity) + 0.5 * m_left * acceleration) > m_openWay) {
        return false;
    }
    uint32_t closed = 0;
    for (uint32_t i = 0; i < m_heldCount; ++i) closed += isClosed(i) ? 1 : 0;
    return closed == m_nearBoxes;
}

template<class P>
void ExactStep::turn(const P &phase, double t) {
    if (!(m_params.options & PHYS_OPTION_ORIENTATION)) return;
    constexpr int kParts = 16;
    for (int part = 0; part < kParts; ++part) {
        rotate(m_orientation, t / kParts * phase.spinAt(t * (part + 0.5) / kParts));
    }
}

namespace {

Losses lossesOf(const Resisted &phase, double t) { return phase.losses(t); }
Losses lossesOf(const Series &phase, double t) { return phase.losses(t); }
Losses lossesOf(const Uniform &, double) { return {}; }

} // namespace

template<class P>
void ExactStep::follow(const P &phase, const End &end, const Border &border) {
    const double t = end.after;
    if (m_report.wanted() && t > 0.0) {
        Losses lost = lossesOf(phase, t);
        if constexpr (std::is_same_v<P, Uniform>) {
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
    const double passed = std::min(t + end.rest, m_left);
    m_elapsed += passed;
    m_left -= passed;
    settle(end, border);
}

/// What the end of a phase makes exact.
void ExactStep::settle(const End &end, const Border &border) {
    const double R = m_scene.radius;
    const double before = glm::length(m_motion.velocity);
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
    // Nothing but rounding is left of a slip at what sticks, and of a velocity that ends with it.
    const double rounding = 4e-13 * speedScale(moment());
    for (int sweep = 0; sweep < 4; ++sweep) {
        for (uint32_t i = 0; i < m_heldCount; ++i) {
            const Mode mode = m_response.reactions[i].mode;
            if (mode == Mode::sticking || (mode == Mode::slipping && end.cause == Cause::grip)) stick(i, rounding);
        }
    }
    if (end.cause == Cause::grip || end.cause == Cause::stop) {
        if (glm::length(m_motion.velocity) <= rounding) m_motion.velocity = Vec3(0.0);
        if (R * glm::length(m_motion.spin) <= rounding) m_motion.spin = Vec3(0.0);
    }
    keepContacts();
    if (end.cause == Cause::border) m_position[border.axis] = border.coordinate;
}

/// Lasting contacts are kept at the radius, and nothing is left of a velocity across them.
void ExactStep::keepContacts() {
    const double R = m_scene.radius;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        if (!isClosed(i)) continue;
        const Contact &contact = contactOf(i);
        const phys_box &box = m_scene.boxes[contact.box];
        Vec3 away(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const int side = contact.sides[axis];
            if (side != 0) away[axis] = m_position[axis] - (side > 0 ? (&box.max.x)[axis] : (&box.min.x)[axis]);
        }
        const Vec3 n = contact.isFace() ? contact.normal : hat(away);
        const double speed = glm::dot(m_motion.velocity, n);
        for (int axis = 0; axis < 3; ++axis) {
            const int side = contact.sides[axis];
            if (side == 0) continue;
            m_position[axis] = (side > 0 ? (&box.max.x)[axis] : (&box.min.x)[axis]) + R * n[axis];
            if (contact.isFace()) m_motion.velocity[axis] = 0.0;
        }
        if (!contact.isFace()) m_motion.velocity -= speed * n;
    }
}

/// Ends the slip at a contact by an impulse of its friction, if it is no more than `most`.
void ExactStep::stick(uint32_t i, double most) {
    const Held &held = m_held[i];
    if (held.isGlued || held.friction == 0.0) return;
    const double R = m_scene.radius;
    const Vec3 slip = slipAt(moment(), held.normal);
    if (glm::length(slip) > most) return;
    if (held.normal.z == 1.0) {
        // On a floor: the spin that belongs to the velocity to the last bit.
        m_motion.velocity -= 2.0 / 7.0 * Vec3(slip.x, slip.y, 0.0);
        const Vec3 rolls = rollingSpin(inPlane(m_motion.velocity), R);
        m_motion.spin = {rolls.x, rolls.y, m_motion.spin.z};
        return;
    }
    m_motion.velocity -= 2.0 / 7.0 * slip;
    m_motion.spin += 5.0 / 7.0 / R * glm::cross(held.normal, slip);
}

} // namespace phys
