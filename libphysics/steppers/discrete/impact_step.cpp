// SPDX-License-Identifier: MIT
// The impacts of a substep, which happen at its start: model.md 13.5.
#include "contact_step.h"

#include "contact/near.h"
#include "scene/nearest.h"

#include <cmath>

namespace phys {

Vec3 leastWay(std::span<Push> pushes, double negligible) {
    Work work; // limited as for a step of `exact`
    const Vec3 way = leastPush(pushes, negligible, work);
    if (pushes.size() < 2) return way;
    std::reverse(pushes.begin(), pushes.end());
    return 0.5 * (way + leastPush(pushes, negligible, work));
}

ExplicitLanding::ExplicitLanding(const StepContext &context, const Contacts &contacts, double h, Ball &ball)
    : m_early(-0.5 * h * context.params().gravity.z) {
    // It would make the ball approach what it slides along or leaves above it, which then would take part in the
    // landing from its beginning, not only once the floor throws the ball against it.
    const bool isCovered = std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        return contact.normal.z < 0.0 &&
               -glm::dot(ball.velocity, contact.normal) <= std::max(m_early, contact.restSpeed);
    });
    // Also where that velocity is too slow to bounce.
    m_lands = m_early > 0.0 && !isCovered && std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
                  return contact.isTop && -ball.velocity.z > std::max(m_early, contact.restSpeed);
              });
    if (m_lands) ball.velocity.z += m_early;
}

void ExplicitLanding::leave(Ball &ball) const {
    if (!m_lands) return;
    if (ball.velocity.z < 0.0)
        ball.velocity.z -= m_early; // as it was
    else
        ball.velocity.z = std::max(0.0, ball.velocity.z - m_early);
}

namespace {

/// Finds contacts opposite to those that the ball approaches, with a gap between: the ball can't be at both at once.
/// Returns whether there were any.
bool dropFacing(const StepContext &context, const Ball &ball, Contacts &contacts) {
    const Contacts all = contacts;
    const auto approaches = [&](const Contact &contact) { return glm::dot(ball.velocity, contact.normal) < 0.0; };
    contacts.drop([&](const Contact &later) {
        if (approaches(later)) return false;
        return std::any_of(all.begin(), all.end(), [&](const Contact &first) {
            const bool hasRoom = !touches(context, first) || !touches(context, later);
            return approaches(first) && hasRoom && glm::length(first.normal + later.normal) <= kSameNormal;
        });
    });
    return contacts.count() < all.count();
}

/// An edge or corner ahead gets the normal of the place where the ball meets it if it moves straight on, by up to the
/// way over R away from that of its place now: an error that a flight after the impact magnifies. The contact becomes
/// that of the plane there.
void meetAhead(const StepContext &context, double h, const Ball &ball, Contacts &contacts) {
    for (Contact &contact : contacts) {
        if (contact.isFace() || touches(context, contact)) continue;
        const Vec3 offset = contact.across(ball.position - contact.point);
        const Vec3 velocity = contact.across(ball.velocity);
        // |offset + t velocity| = R
        const double beyond = glm::dot(offset, offset) - context.radius() * context.radius();
        const double closing = -glm::dot(offset, velocity);
        const double root = closing * closing - glm::dot(velocity, velocity) * beyond;
        if (closing <= 0.0 || root < 0.0) continue;
        const double t = beyond / (closing + std::sqrt(root));
        if (!(t <= h)) continue;
        contact.normal = glm::normalize(offset + t * velocity);
        contact.gap = -t * glm::dot(velocity, contact.normal);
    }
}

bool hasRoom(const StepContext &context, const Vec3 &position) {
    const Scene &scene = context.scene();
    const double overlapping = scene.radius - context.setting.tolerance;
    bool overlaps = false;
    visitNear(scene, position, scene.radius, [&](const phys_box &box, uint32_t) {
        overlaps = overlaps || squaredDistance(box, position) < overlapping * overlapping;
    });
    return !overlaps;
}

/// The contacts that hold the ball at its place before an impact: it neither approaches nor leaves them.
NormalSpan lastingNormals(const StepContext &context, const Contacts &contacts, const Motion &before) {
    NormalSpan lasting;
    const double negligible = negligibleSpeed(before, context.radius());
    for (const Contact &contact : contacts) {
        const double speed = std::abs(glm::dot(before.velocity, contact.normal));
        if (touches(context, contact) && speed <= std::max(contact.restSpeed, negligible)) lasting.add(contact.normal);
    }
    return lasting;
}

/// The share of an approach that impacts gave back: less than the restitution where other contacts took some of it.
double rebound(const Contact &contact, double approach, const Motion &after) {
    constexpr double kRounded = 1.0 - 1e-9;
    if (approach <= contact.restSpeed) return 0.0;
    const double returned = std::max(0.0, glm::dot(after.velocity, contact.normal)) / approach;
    return returned < kRounded * contact.restitution ? returned : contact.restitution;
}

/// The shortest way to where an impact leaves the ball: restitution takes its share of the gaps too, model.md 13.5.
/// Only of those that the motion before it closes within h, so that the way is never longer than that motion, and
/// without what leads into other contacts, or off those that last: the way to a kerb, or to the edge of a roof, leads
/// along the floor. A ball lifted off it would fall, for the root of h.
Vec3 wayToImpact(const StepContext &context, const Contacts &contacts, double h, const Motion &before,
                 const Motion &after) {
    constexpr double kParallel = 1e-9;
    std::array<Push, Contacts::kMost> closing, others;
    uint32_t closingCount = 0, otherCount = 0;
    const NormalSpan lasting = lastingNormals(context, contacts, before);
    for (const Contact &contact : contacts) {
        const Vec3 across = lasting.across(contact.normal);
        const double share = across == contact.normal ? 1.0 : glm::length(across);
        if (share <= kParallel) continue;
        const double approach = -glm::dot(before.velocity, across);
        const double returned = rebound(contact, approach, after);
        // A share of the approach along lasting contacts that goes on after the impact leads there by itself.
        const double kept = share < 1.0 ? std::clamp(-glm::dot(after.velocity, across) / approach, 0.0, 1.0) : 0.0;
        const double way = (1.0 - returned * returned) * (1.0 - kept) * contact.gap;
        const double gain = 0.5 * share * share * contact.restSpeed; // what gravity adds to it within h
        const bool isReached = approach > 0.0 && contact.gap <= h * (approach + gain);
        if (isReached && way > context.setting.tolerance)
            closing[closingCount++] = {-across / share, way / share};
        else
            others[otherCount++] = {across / share, -std::max(0.0, contact.gap) / share};
    }
    if (closingCount == 0) return Vec3(0.0);
    const double negligible = 0.5 * context.setting.tolerance;
    const Vec3 way = leastWay({closing.data(), closingCount}, negligible);
    if (otherCount == 0) return way;
    for (uint32_t i = 0; i < otherCount; ++i) others[i].wanted -= glm::dot(way, others[i].normal);
    return way + leastWay({others.data(), otherCount}, negligible);
}

/// Moves the ball there, if it has room and the impact takes more energy than the way.
void moveToImpact(const StepContext &context, const Impacts &impacts, const Vec3 &way, Contacts &contacts, Ball &ball) {
    const double lifted = -glm::dot(context.setting.gravity(), way);
    if (way == Vec3(0.0) || lifted > impacts.lostNormal || !hasRoom(context, ball.position + way)) return;
    ball.position += way;
    for (Contact &contact : contacts) contact.gap += glm::dot(contact.normal, way);
}

} // namespace

bool hit(const StepContext &context, Contacts &contacts, double after, double h, Ball &ball) {
    constexpr double kModes = 4e-8; // of the speed: an approach that modes may leave, model.md 13.5
    const double speed = glm::length(ball.velocity);
    const bool any = std::any_of(contacts.begin(), contacts.end(), [&](const Contact &contact) {
        const double least = contact.isFace() ? 0.0 : kModes * speed;
        return -glm::dot(ball.velocity, contact.normal) > std::max(contact.restSpeed, least);
    });
    if (!any) return false;
    meetAhead(context, h, ball, contacts);
    Motion motion = motionOf(ball);
    Work work; // limited as for a step of `exact`
    Impacts impacts = resolveImpacts(contacts, context.radius(), motion, work);
    if (impacts.rounds == kMostImpactRounds && dropFacing(context, ball, contacts)) {
        motion = motionOf(ball);
        impacts = resolveImpacts(contacts, context.radius(), motion, work);
    }
    if (impacts.rounds > 1) context.work.add(work.done()); // a single round belongs to the substep, or event
    const Vec3 way = wayToImpact(context, contacts, h, motionOf(ball), motion);
    setMotion(motion, ball);
    moveToImpact(context, impacts, way, contacts, ball);
    context.report.lostImpact(impacts.lostNormal);
    context.report.lostSlip(impacts.lostSlip);
    context.report.passes(impacts.rounds);
    if (!context.report.wanted()) return true;
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        const Contact &contact = contacts[i];
        if (impacts.approach[i] == 0.0) continue;
        context.report.event(contact.isTop ? PHYS_EVENT_LANDING : PHYS_EVENT_IMPACT, after, contact.point,
                             contact.normal, impacts.approach[i],
                             std::max(0.0, glm::dot(ball.velocity, contact.normal)),
                             context.scene().givenBox(contact.box, contact.point));
    }
    return true;
}

} // namespace phys
