// SPDX-License-Identifier: MIT
// What happens to the ball in no time: impacts, and which contacts last then. model.md 8.1 and 13.2.
#include "contact/held.h"
#include "contact/impact.h"
#include "exact/exact_step.h"
#include "scene/nearest.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Rounds of impacts at one moment: each ends bounces that are none, which may drive the ball into another contact.
constexpr int kMostRounds = 16;

/// Bounces that rise no higher than this, in radii, are the last of infinitely many: model.md 6.4.
constexpr double kLastBounce = 1e-13;
/// Where what is between two bounces has another law than what comes after the last: the error is of first order there.
constexpr double kLastHop = 1e-26;

/// But with a restitution above this the bounces down there would never end.
constexpr double kSlowDecay = 0.95;

/// How much higher the last bounces are with each quarter of its work that a step has done: rather less exact than
/// none.
constexpr double kHigher = 100.0;

} // namespace

/// Takes all impacts of the moment, and looks at what lasts then.
void ExactStep::resolve() {
    m_isAnswered = false;
    const double speed = glm::length(m_motion.velocity), negligible = negligibleSpeed(m_motion, m_scene.radius);
    if (movesAlongGround()) return holdGround();
    touch();
    if (movesAlongFaces()) {
        takeFaces();
        return keepFaces();
    }
    const bool wasCarried = isCarried(negligible);
    bool hits = false;
    for (int round = 0; round < kMostRounds && !m_work.isTooMuch() && collide(negligible); ++round) {
        hits = true;
        // Nothing but rounding is left of a velocity that led straight into what it hit.
        if (glm::length(m_motion.velocity) <= 4.0 * kRounding * speed) m_motion.velocity = Vec3(0.0);
        touch();
        takeEdges();
        hold(negligible);
    }
    hold(negligible);
    if (collide(negligible)) hold(negligible);
    if (isApproaching(negligible)) stopBounces(negligible);
    roll(hits && wasCarried);
}

/// Contacts that drive the ball into each other again and again: none of them bounces any more.
void ExactStep::stopBounces(double negligible) {
    for (Contact &contact : m_contacts) contact.restitution = 0.0;
    collide(negligible);
    collectHeld(negligible);
    project();
}

/// Whether the ball touches nothing but faces, and has no velocity across any: nothing is hit then, and all of them
/// last.
bool ExactStep::movesAlongFaces() const {
    if (m_contacts.count() > kMostHeld) return false;
    return std::all_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &contact) {
        return contact.isFace() && glm::dot(m_motion.velocity, contact.normal) == 0.0;
    });
}

/// Whether the ball starts on a floor in a region of it, at one smooth wall at most, and has no velocity across them:
/// then nothing depends on the order of contacts.
bool ExactStep::movesAlongGround() const {
    const Vec3 &v = m_motion.velocity;
    if (m_elapsed > 0.0 || !isOnGround() || m_ground.count() > 2 || v.z != 0.0) return false;
    const bool isSmooth = !m_setting.isRigid() || m_params.wall_friction == 0.0;
    return m_ground.count() == 1 || (isSmooth && v[m_region->leansAlong(m_position)] == 0.0);
}

/// What is touched there needs no search.
void ExactStep::holdGround() {
    m_contacts.clear();
    m_contacts.add(contactAtFace(m_setting, m_position, m_region->floor, 2, 1));
    m_position.z = m_contacts[0].point.z + m_scene.radius;
    if (m_ground.count() > 1) {
        const int axis = m_region->leansAlong(m_position);
        const FloorRegion::Range &range = m_region->along[static_cast<size_t>(axis)];
        const int side = m_position[axis] == range.lowFace ? 1 : -1;
        m_position[axis] = side > 0 ? range.lowFace : range.highFace; // a zero may have the other sign
        m_contacts.add(contactAtFace(m_setting, m_position, m_ground[1], axis, side));
    }
    keepFaces();
}

/// All contacts last, and nothing is left of a velocity across them.
void ExactStep::keepFaces() {
    m_heldCount = 0;
    const bool moves = m_motion.velocity != Vec3(0.0);
    for (uint32_t i = 0; i < m_contacts.count(); ++i) {
        addHeld(i);
        for (int axis = 0; axis < 3 && moves; ++axis) {
            if (m_contacts[i].sides[axis] != 0) m_motion.velocity[axis] = 0.0;
        }
    }
    roll(false);
}

/// Puts the ball exactly at the radius of the faces that it touches, and amid those that face each other: at the radius
/// of either, a ball at rest would be moved to and fro.
void ExactStep::takeFaces() {
    constexpr uint32_t kLow = 1, kHigh = 2; // the side of the face that the ball is on
    std::array<Vec3, 2> at{};
    std::array<uint32_t, 3> sides{};
    for (const Contact &contact : m_contacts) {
        if (!contact.isFace()) continue;
        for (int axis = 0; axis < 3; ++axis) {
            const int side = contact.sides[axis];
            if (side == 0) continue;
            at[side > 0 ? 1 : 0][axis] = contact.point[axis] + side * m_scene.radius;
            sides[static_cast<size_t>(axis)] |= side > 0 ? kHigh : kLow;
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        const uint32_t touched = sides[static_cast<size_t>(axis)];
        if (touched == 0) continue;
        m_position[axis] = touched == (kLow | kHigh) ? 0.5 * (at[0][axis] + at[1][axis]) : at[touched - 1][axis];
    }
}

/// The same for edges and corners beside other contacts: hit where they are nearly touched, they drive the ball to and
/// fro without end.
void ExactStep::takeEdges() {
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds && m_contacts.count() > 1; ++round) {
        Vec3 off(0.0); // of all alike: nothing depends on their order
        double count = 0.0;
        for (const Contact &contact : m_contacts) {
            if (contact.isFace()) continue;
            const double gap = nearest(m_scene.boxes[contact.box], m_position).distance - m_scene.radius;
            if (std::abs(gap) > kRounding * m_scene.radius) off += gap * contact.normal;
            count += 1.0;
        }
        if (off == Vec3(0.0)) return;
        m_position -= off / count;
        takeFaces();
    }
}

/// Whether a floor carries the ball of the rolling model.
bool ExactStep::isCarried(double negligible) const {
    return std::any_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &contact) {
        return contact.isGlued && std::abs(glm::dot(m_motion.velocity, contact.normal)) <= negligible;
    });
}

void ExactStep::touch() {
    if (isOnGround() && m_elapsed == 0.0) {
        m_work.add(Work::kBox * m_ground.count());
        return findContactsAmong(m_setting, m_position, m_motion, {m_ground.begin(), m_ground.count()}, m_contacts);
    }
    m_work.add(Work::kBox * m_scene.boxesNear(m_position.x, m_position.y, m_scene.hasManyBoxes).size());
    findContacts(m_setting, m_position, m_motion, Vec3(0.0), m_contacts);
    m_contacts.dropHidden(m_scene.tolerance);
}

/// model.md 6.4: what bounces no higher than rounding bounces for the last time.
void ExactStep::endBounces(double negligible) {
    const double fast = squareOfFastBounce();
    const bool bounceOn = std::all_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &contact) {
        const double speed = glm::dot(m_motion.velocity, contact.normal), after = contact.restitution * speed;
        return speed >= -negligible || after * after > fast;
    });
    if (bounceOn) return;
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
Vec3 ExactStep::actingAcceleration() {
    if (m_heldCount == 0) return m_setting.gravity();
    const Response response = respond(moment(), held(), m_work);
    return response.isFound ? response.acceleration : m_setting.gravity();
}

bool ExactStep::isApproaching(double negligible) const {
    return std::any_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &contact) {
        return glm::dot(m_motion.velocity, contact.normal) < -negligible;
    });
}

/// True if anything was hit.
bool ExactStep::collide(double negligible) {
    if (!isApproaching(negligible)) return false;
    endBounces(negligible);
    const Impacts impacts = resolveImpacts(m_contacts, m_scene.radius, m_motion, m_work);
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
    if (endsAsSeries(contact)) return 0.0;
    const bool isUpright = contact.normal.z == 0.0;
    const bool isSmooth = (isUpright && contact.friction == 0.0) || contact.restitution > kSlowDecay;
    const double height = isSmooth ? lastHeight() : higher() * kLastHop * R;
    return std::sqrt(2.0 * std::max(0.0, back) * height);
}

/// Whether the bounces on a face end as one sum: nothing else is touched, and from now on each is like the one before.
bool ExactStep::endsAsSeries(const Contact &face) const {
    constexpr double kElastic = 1.0 - 1e-6; // restitution: such bounces end in no time to speak of
    const double eps = face.restitution, back = -glm::dot(m_setting.gravity(), face.normal);
    if (m_contacts.count() != 1 || !face.isFace() || m_work.quarters() > 0) return false;
    if (!(back > 0.0) || eps <= kSlowDecay || eps > kElastic) return false;
    if (face.friction == 0.0) return true;
    const double push = (1.0 + eps) * std::abs(glm::dot(m_motion.velocity, face.normal));
    return endsSlips(face) && 2.0 / 7.0 * glm::length(slipAt(moment(), face.normal)) <= face.friction * push;
}

/// As high as the last bounces rise at smooth contacts, m.
double ExactStep::lastHeight() const { return std::max(m_scene.tolerance, higher() * kLastBounce * m_scene.radius); }

/// How much higher they rise in a step of much work.
double ExactStep::higher() const {
    double factor = 1.0;
    for (uint64_t quarters = m_work.quarters(); quarters > 0; --quarters) factor *= kHigher;
    return factor;
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

/// (m/s)^2: a bounce faster than its root isn't the last, whatever accelerates the ball.
double ExactStep::squareOfFastBounce() const {
    constexpr double kMost = 1e3; // relative: no contacts make more of the accelerations at hand
    return 2.0 * kMost * accelerationScale(moment()) * lastHeight();
}

/// Whether all contacts but those that are held are left too fast for a last bounce.
bool ExactStep::areBouncing() const {
    const double fast = squareOfFastBounce();
    return std::all_of(m_contacts.begin(), m_contacts.end(), [&](const Contact &contact) {
        const auto held = m_lasting.begin() + m_heldCount;
        const double speed = glm::dot(m_motion.velocity, contact.normal);
        if (speed < 0.0 || speed * speed > fast) return true;
        return std::find(m_lasting.begin(), held, static_cast<uint32_t>(&contact - m_contacts.begin())) != held;
    });
}

/// Ends the bounce of one more contact, rather of one that doesn't drive the ball into another: false if none bounces
/// so low.
bool ExactStep::holdNext(double negligible) {
    if (areBouncing()) return false;
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
    takeFaces();
    collectHeld(negligible);
    while (m_heldCount < std::min(m_contacts.count(), kMostHeld) && holdNext(negligible)) {
    }
    project();
}

/// Whether the ball is too fast for the groove between two contacts on the same side of it: so fast that it rises over
/// their edges, while its speeds across the contacts, which all but have one normal, are rounding. model.md 6.4.
bool ExactStep::crosses(const Vec3 &first, const Vec3 &second, const Vec3 &along) const {
    if (glm::dot(first, second) <= 0.0) return false;
    const Vec3 across = m_motion.velocity - glm::dot(m_motion.velocity, along) * along;
    const Vec3 wide = first - second; // in radii
    return glm::dot(across, across) > glm::dot(wide, wide) * m_scene.radius * glm::length(m_setting.gravity());
}

/// Removes what is left of the velocity across the lasting contacts.
void ExactStep::project() {
    Vec3 &v = m_motion.velocity;
    if (v == Vec3(0.0)) return;
    for (uint32_t i = 0; i < m_heldCount; ++i) {
        const Vec3 &n = m_held[i].normal;
        for (uint32_t j = 0; j < i; ++j) {
            const Vec3 line = glm::cross(n, m_held[j].normal);
            if (glm::dot(line, line) < kParallel * kParallel) continue;
            const Vec3 along = hat(line);
            if (crosses(m_held[i].normal, m_held[j].normal, along)) continue;
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

} // namespace phys
