// SPDX-License-Identifier: MIT
#include "exact/resolve.h"

#include "contact/impact.h"
#include "exact/last_bounce.h"
#include "exact/response.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

/// Rounds of impacts at one moment: each ends last bounces, which may drive the ball into another contact.
constexpr int kMostRounds = 16;

/// Finds what the ball touches.
void touch(const Ground &ground, MovingBall &ball, Contacts &contacts) {
    const Vec3 &place = ball.position;
    ball.work.add(Work::kTouch);
    if (ground.holds(ball)) {
        ball.work.add(Work::kBox * ground.boxes().size());
        return findContactsAmong(ball.setting, place, ball.motion, ground.boxes(), contacts);
    }
    ball.work.add(Work::kBox * ball.scene().boxesNear(place.x, place.y, ball.scene().hasManyBoxes).size());
    findContacts(ball.setting, place, ball.motion, Vec3(0.0), contacts);
    contacts.dropHidden(ball.scene().tolerance);
}

bool isApproaching(const MovingBall &ball, const Contacts &contacts, double negligible) {
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        return glm::dot(ball.motion.velocity, contact.normal) < -negligible;
    });
}

/// The acceleration of the ball if only the lasting contacts push.
Vec3 actingAcceleration(const Touching &touching, MovingBall &ball) {
    if (touching.count() == 0) return ball.setting.gravity();
    const Response response = respond(ball.moment(), touching.held(), ball.work);
    return response.isFound ? response.acceleration : ball.setting.gravity();
}

/// model.md 6.4: a bounce no higher than rounding is the last.
void endBounces(double negligible, MovingBall &ball, Touching &touching) {
    const double fast = squareOfFastBounce(ball);
    Contacts &contacts = touching.contacts;
    const bool bounceOn = std::all_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        const double speed = glm::dot(ball.motion.velocity, contact.normal), after = contact.restitution * speed;
        return speed >= -negligible || after * after > fast;
    });
    if (bounceOn) return;
    ball.work.add(Work::kTouch);
    touching.holdStill(ball.motion.velocity, negligible, ball.params());
    const Vec3 acting = actingAcceleration(touching, ball);
    for (Contact &contact : contacts) {
        const double speed = glm::dot(ball.motion.velocity, contact.normal);
        if (speed < -negligible && contact.restitution * -speed <= lastBounce(ball, contacts, contact, acting)) {
            contact.restitution = 0.0;
        }
    }
}

/// Whether the ball leaves all contacts, except for those that last, too fast for a last bounce.
bool areBouncing(const MovingBall &ball, const Touching &touching) {
    const double fast = squareOfFastBounce(ball);
    const Contacts &contacts = touching.contacts;
    return std::all_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        const double speed = glm::dot(ball.motion.velocity, contact.normal);
        if (speed < 0.0 || speed * speed > fast) return true;
        return touching.lasts(static_cast<uint32_t>(&contact - contacts.begin()));
    });
}

/// Ends the bounce at one more contact, preferably one that doesn't drive the ball into another: false if no bounce is
/// low enough.
bool holdNext(double negligible, MovingBall &ball, Touching &touching) {
    if (areBouncing(ball, touching)) return false;
    const Vec3 acting = actingAcceleration(touching, ball);
    const Contacts &contacts = touching.contacts;
    uint32_t next = Contacts::kMost;
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        const double speed = glm::dot(ball.motion.velocity, contacts[i].normal);
        if (touching.lasts(i)) continue;
        if (speed < 0.0 || speed > lastBounce(ball, contacts, contacts[i], acting)) continue;
        const Vec3 left = ball.motion.velocity - speed * contacts[i].normal;
        const bool isFree = std::none_of(contacts.begin(), contacts.end(), [&](const Contact &other) {
            return glm::dot(left, other.normal) < -negligible;
        });
        if (isFree || next == Contacts::kMost) next = i;
        if (!isFree) continue;
        ball.motion.velocity = left;
        break;
    }
    if (next == Contacts::kMost) return false;
    touching.hold(next, ball.params());
    return true;
}

/// Contacts along which the others that last leave no velocity: they last, too.
void holdBeside(double negligible, const MovingBall &ball, Touching &touching) {
    for (uint32_t i = 0; i < touching.contacts.count(); ++i) {
        const double speed = glm::dot(ball.motion.velocity, touching.contacts[i].normal);
        if (std::abs(speed) <= negligible && !touching.lasts(i)) touching.hold(i, ball.params());
    }
}

/// The contacts that last: exactly at the radius, with no velocity along the normal or one whose bounce ends at once.
void holdFound(double negligible, MovingBall &ball, Touching &touching) {
    takeFaces(touching.contacts, kAll, ball);
    touching.holdStill(ball.motion.velocity, negligible, ball.params());
    while (touching.count() < std::min(touching.contacts.count(), kMostHeld) && holdNext(negligible, ball, touching)) {
    }
    project(touching, kAll, ball);
    holdBeside(negligible, ball, touching);
}

/// The same. A ball that stops on a border no longer belongs to the side towards which it moved: model.md 13.1.
void hold(const Ground &ground, double negligible, MovingBall &ball, Touching &touching) {
    const Vec3 given = ball.motion.velocity;
    holdFound(negligible, ball, touching);
    if (ball.motion.velocity == given) return;
    touch(ground, ball, touching.contacts);
    holdFound(negligible, ball, touching);
}

/// Contacts that drive the ball into each other repeatedly: all of their bounces end.
void stopBounces(double negligible, MovingBall &ball, Touching &touching) {
    for (Contact &contact : touching.contacts) contact.restitution = 0.0;
    collide(negligible, ball, touching);
    touching.holdStill(ball.motion.velocity, negligible, ball.params());
    project(touching, kAll, ball);
}

/// Rolling model: whether a top face carries a ball with this spin. The reactions at other contacts may lift it off, or
/// press it down.
bool isCarried(const Touching &touching, uint32_t i, const Vec3 &spin, MovingBall &ball) {
    if (touching.count() == 1) return ball.params().gravity.z <= 0.0;
    Moment moment = ball.moment();
    moment.spin = spin;
    const Response response = respond(moment, touching.held(), ball.work);
    return !response.isFound || isClosed(response, i);
}

/// Rolling model: the spin of a supported ball isn't independent. Energy (J/kg, of either sign) of the difference of a
/// given spin from it.
double roll(const Touching &touching, MovingBall &ball) {
    double lost = 0.0;
    for (uint32_t i = 0; i < touching.count(); ++i) {
        const double R = ball.radius();
        const Vec3 spin = rollingSpin(inPlane(ball.motion.velocity), R);
        if (!touching.held(i).isGlued || (ball.motion.spin != spin && !isCarried(touching, i, spin, ball))) continue;
        lost += 0.2 * R * R * (glm::dot(ball.motion.spin, ball.motion.spin) - glm::dot(spin, spin));
        ball.motion.spin = spin;
    }
    return lost;
}

/// Whether the ball touches only faces and has no velocity along their normals: then there is no impact, and all of
/// them last.
bool movesAlongFaces(const MovingBall &ball, const Contacts &contacts) {
    if (contacts.count() > kMostHeld) return false;
    return std::all_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        return contact.isFace() && glm::dot(ball.motion.velocity, contact.normal) == 0.0;
    });
}

/// Makes all contacts last and removes any velocity along their normals.
void holdFaces(MovingBall &ball, Touching &touching) {
    touching.holdNone();
    const bool moves = ball.motion.velocity != Vec3(0.0);
    for (uint32_t i = 0; i < touching.contacts.count(); ++i) {
        touching.hold(i, ball.params());
        if (moves) ball.motion.velocity[axisOf(touching.contacts[i])] = 0.0;
    }
    ball.report.lostSlip(roll(touching, ball));
}

/// Rolling model: whether the ball rolls on a floor. A ball that is about to land doesn't yet.
bool isRolling(const MovingBall &ball, const Contacts &contacts, double negligible) {
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        return contact.isGlued && std::abs(glm::dot(ball.motion.velocity, contact.normal)) <= negligible &&
               isNoSlip(ball.moment(), slipAt(ball.moment(), contact.normal));
    });
}

} // namespace

bool collide(double negligible, MovingBall &ball, Touching &touching) {
    const Contacts &contacts = touching.contacts;
    if (!isApproaching(ball, contacts, negligible)) return false;
    endBounces(negligible, ball, touching);
    const Impacts impacts = resolveImpacts(contacts, ball.radius(), ball.motion, ball.work);
    ball.report.lostImpact(impacts.lostNormal);
    ball.report.lostSlip(impacts.lostSlip);
    ball.report.passes(impacts.rounds);
    if (!ball.report.wanted()) return true;
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        if (impacts.approach[i] >= 0.0) continue;
        ball.event(contacts[i].isTop ? PHYS_EVENT_LANDING : PHYS_EVENT_IMPACT, contacts[i], impacts.approach[i],
                   std::max(0.0, glm::dot(ball.motion.velocity, contacts[i].normal)));
    }
    return true;
}

void resolve(const Ground &ground, MovingBall &ball, Touching &touching) {
    const double speed = glm::length(ball.motion.velocity), negligible = ball.negligibleSpeed();
    touch(ground, ball, touching.contacts);
    if (movesAlongFaces(ball, touching.contacts)) {
        takeFaces(touching.contacts, kAll, ball);
        return holdFaces(ball, touching);
    }
    const bool wasRolling = isRolling(ball, touching.contacts, negligible);
    bool hits = false;
    for (int round = 0; round < kMostRounds && !ball.work.isTooMuch(); ++round) {
        if (!collide(negligible, ball, touching)) break;
        hits = true;
        // The remainder of a velocity straight into the boxes that it hit is rounding.
        if (glm::length(ball.motion.velocity) <= 4.0 * kRounding * speed) ball.motion.velocity = Vec3(0.0);
        touch(ground, ball, touching.contacts);
        if (takeEdges(touching.contacts, ball)) touch(ground, ball, touching.contacts); // maybe something else, too
        hold(ground, negligible, ball, touching);
    }
    hold(ground, negligible, ball, touching);
    if (collide(negligible, ball, touching)) hold(ground, negligible, ball, touching);
    if (isApproaching(ball, touching.contacts, negligible)) stopBounces(negligible, ball, touching);
    const double lost = roll(touching, ball);
    if (hits && wasRolling) return ball.report.lostImpact(lost); // it is part of the impact's loss
    ball.report.lostSlip(lost);
}

} // namespace phys
