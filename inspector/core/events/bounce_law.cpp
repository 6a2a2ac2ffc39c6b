// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/events/bounce_law.h"

#include "core/events/event_figures.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

/// Relative difference of speeds below which it is rounding.
constexpr double kLawRounding = 1e-13;

/// Gaps below this share of the radius count as zero.
constexpr double kTouching = 1e-9;

double dot(const phys_vec3 &a, const phys_vec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(const phys_vec3 &a) { return std::sqrt(dot(a, a)); }

phys_vec3 cross(const phys_vec3 &a, const phys_vec3 &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// a + factor * b
phys_vec3 plus(const phys_vec3 &a, double factor, const phys_vec3 &b) {
    return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

phys_vec3 tangentialPart(const phys_vec3 &a, const phys_vec3 &normal) { return plus(a, -dot(a, normal), normal); }

double share(double part, double whole) { return whole > 0.0 ? part / whole : part; }

bool isRigid(const LoggedEvent &bounce) { return bounce.step.params.model == PHYS_MODEL_RIGID; }

/// How much gravity and friction can change the tangential velocity within the step, m/s. Of gravity's part along the
/// surface 5/7 acts where the ball rolls (model.md 2.1). In the rigid model friction changes the slip by 7/2 mu gn
/// (3.6), of which an impact that sticks takes 2/7.
double allowanceOf(const LoggedEvent &bounce, const phys_vec3 &normal) {
    const phys_params &params = bounce.step.params;
    const bool isInAir = (bounce.step.before.flags | bounce.step.after.flags) & PHYS_AIRBORNE;
    const phys_vec3 drive{params.gravity.x, params.gravity.y, isInAir ? params.gravity.z : 0.0};
    const double pull = length(tangentialPart(drive, normal));
    const double press = std::abs(params.gravity.z);
    if (isRigid(bounce)) return bounce.step.dt * (9.0 / 7.0 * pull + 2.0 * params.sliding_friction * press);
    return bounce.step.dt * (isInAir ? pull : 5.0 / 7.0 * (pull + params.rolling_friction * press));
}

QString verdict(double deviation) {
    if (deviation == 0.0) return QStringLiteral("to the last bit");
    if (deviation < kLawRounding) return QStringLiteral("to rounding (%1)").arg(QString::number(deviation, 'g', 1));
    return QStringLiteral("off by %1 %").arg(QString::number(100.0 * deviation, 'g', 2));
}

QString normalText(const LoggedEvent &bounce, const NormalLaw &law) {
    const bool isLanding = bounce.event.kind == PHYS_EVENT_LANDING;
    const QString section = isRigid(bounce) ? QStringLiteral("2.2 F3")
                            : isLanding     ? QStringLiteral("2.1 R6")
                                            : QStringLiteral("2.1 R2");
    QString text = QStringLiteral("v'n = -e vn: %1 %2 %3 × %4   (model.md %5)")
                       .arg(speedText(law.found), law.ends ? QStringLiteral("instead of") : QStringLiteral("="),
                            figureText(law.restitution), speedText(law.before), section);
    if (law.ends) return text + QStringLiteral("; too slow to come off again, so it stays in contact (model.md 6.4)");
    return text + QStringLiteral("; ") + verdict(law.deviation);
}

QString frictionText(const TangentialLaw &law) {
    return QStringLiteral("jt = min(mu j, 2/7 |uc|) = min(%1 × %2, 2/7 × %3) = %4: %5   (model.md 2.2 F3)")
        .arg(figureText(law.friction), speedText(law.impulse), speedText(law.slip), speedText(law.tangential),
             law.friction == 0.0 ? QStringLiteral("smooth")
             : law.sticks        ? QStringLiteral("sticks")
                                 : QStringLiteral("slides"));
}

QString tangentialText(const LoggedEvent &bounce, const TangentialLaw &law) {
    const bool isLanding = bounce.event.kind == PHYS_EVENT_LANDING;
    const QString rule = isRigid(bounce) ? QStringLiteral("v't = vt - jt uc/|uc|")
                         : isLanding     ? QStringLiteral("v't = vt   (model.md 2.1 R6)")
                                         : QStringLiteral("v't = vt   (model.md 2.1 R2)");
    QString text = QStringLiteral("%1: %2 after this step, expected %3; ")
                       .arg(rule, speedText(law.found), speedText(law.expected));
    const bool isWithin = law.off <= law.allowance;
    text += isWithin
                ? QStringLiteral("within the %1 that gravity and friction can do in it").arg(speedText(law.allowance))
                : QStringLiteral("off by %1, gravity and friction can do %2 in it")
                      .arg(speedText(law.off), speedText(law.allowance));
    const uint32_t others = bounce.step.eventCount - 1;
    if (others == 0) return text;
    return text + QStringLiteral("; %1 more in the same step").arg(others);
}

} // namespace

double restitutionOf(const LoggedEvent &bounce) {
    const phys_params &params = bounce.step.params;
    return surfaceOf(bounce.event) == Surface::Floor ? params.restitution_floor : params.restitution_wall;
}

double frictionOf(const LoggedEvent &bounce) {
    const phys_params &params = bounce.step.params;
    return surfaceOf(bounce.event) == Surface::Floor ? params.sliding_friction : params.wall_friction;
}

Motion motionOf(const phys_state &state, const phys_vec3 &normal) {
    Motion motion{};
    motion.normal = dot(state.velocity, normal);
    motion.tangential = tangentialPart(state.velocity, normal);
    motion.tangentialSpeed = length(motion.tangential);
    motion.spin = state.spin;
    return motion;
}

NormalLaw normalLaw(const LoggedEvent &bounce) {
    NormalLaw law{};
    law.restitution = restitutionOf(bounce);
    law.before = -bounce.event.speed_before;
    law.expected = law.restitution * law.before;
    law.found = bounce.event.speed_after;
    law.ends = law.found == 0.0 && law.expected > 0.0;
    law.deviation = law.ends ? 0.0 : share(std::abs(law.found - law.expected), law.before);
    return law;
}

/// model.md 2.2 F3. Uses the state before the step, whose velocity and spin may differ from those right before the
/// impact.
TangentialLaw tangentialLaw(const LoggedEvent &bounce, double radius) {
    const phys_vec3 &normal = bounce.event.normal;
    const Motion before = motionOf(bounce.step.before, normal);
    const Motion after = motionOf(bounce.step.after, normal);
    phys_vec3 expected = before.tangential;
    TangentialLaw law{};
    if (isRigid(bounce)) {
        // The contact point moves with v - R (om x n).
        const phys_vec3 slip =
            tangentialPart(plus(bounce.step.before.velocity, -radius, cross(before.spin, normal)), normal);
        law.friction = frictionOf(bounce);
        law.impulse = bounce.event.speed_after - bounce.event.speed_before;
        law.slip = length(slip);
        law.sticks = law.friction * law.impulse >= 2.0 / 7.0 * law.slip;
        law.tangential = std::min(law.friction * law.impulse, 2.0 / 7.0 * law.slip);
        if (law.slip > 0.0) expected = plus(expected, -law.tangential / law.slip, slip);
    }
    law.expected = length(expected);
    law.found = after.tangentialSpeed;
    law.off = length(plus(after.tangential, -1.0, expected));
    law.allowance = allowanceOf(bounce, normal);
    return law;
}

bool BouncePlace::isAtFace(double radius) const { return std::abs(gap) <= kTouching * radius + uncertainty; }

std::optional<BouncePlace> bouncePlace(const LoggedEvent &bounce, double radius) {
    const phys_event &event = bounce.event;
    const phys_state &before = bounce.step.before;
    if (!bounce.isBounce() || !(event.speed_before < 0.0) || bounce.step.firstEvent < event.time) return std::nullopt;
    const double passed = event.time - before.time;
    const double speed = dot(before.velocity, event.normal);
    const double start = dot(plus(before.position, -1.0, event.point), event.normal) - radius;
    BouncePlace place{};
    // The mean speed under a constant acceleration; for any monotonic speed it lies between those at both ends.
    place.gap = start + 0.5 * (speed + event.speed_before) * passed;
    place.uncertainty = 0.5 * std::abs(event.speed_before - speed) * passed;
    place.lateness = place.gap / event.speed_before;
    return place;
}

std::vector<LawLine> lawLines(const LoggedEvent &bounce, double radius) {
    if (!bounce.isBounce()) return {};
    const TangentialLaw tangential = tangentialLaw(bounce, radius);
    std::vector<LawLine> lines{{QStringLiteral("Law"), normalText(bounce, normalLaw(bounce))}};
    if (isRigid(bounce)) lines.push_back({QStringLiteral("Friction"), frictionText(tangential)});
    lines.push_back({QStringLiteral("Along"), tangentialText(bounce, tangential)});
    return lines;
}

} // namespace inspector
