// SPDX-License-Identifier: GPL-3.0-or-later
// The model's laws for a bounce, evaluated for one bounce, and how well it satisfies them. Sections refer to
// libphysics/docs/model.md.
#pragma once

#include "core/events/event_log.h"

#include <QString>

#include <optional>
#include <vector>

namespace inspector {

/// The coefficients of the surface that the ball bounces off.
double restitutionOf(const LoggedEvent &bounce);
double frictionOf(const LoggedEvent &bounce); ///< in the rigid model

/// Components of the ball's velocity and spin at the contact.
struct Motion {
    double normal;          ///< m/s, along the normal
    phys_vec3 tangential;   ///< m/s, in the tangent plane
    double tangentialSpeed; ///< its length
    phys_vec3 spin;         ///< rad/s
};
Motion motionOf(const phys_state &state, const phys_vec3 &normal);

/// v'n = -e vn, with the speeds that the report gives, right before and after.
struct NormalLaw {
    double restitution;
    double before;    ///< m/s, towards the box, >= 0
    double expected;  ///< m/s
    double found;     ///< m/s
    bool ends;        ///< found is 0 instead: the stepper treats so slow a bounce as lasting contact (6.4, 10.3)
    double deviation; ///< share of `before`
};
NormalLaw normalLaw(const LoggedEvent &bounce);

/// Tangential velocity: unchanged in the rolling model (R2, R6), changed by Coulomb's impulse in the rigid one (F3).
/// Steps don't report tangential speeds, so these are of the states before and after the step and include everything
/// else that happened in it.
struct TangentialLaw {
    double expected;  ///< m/s
    double found;     ///< m/s
    double off;       ///< m/s, length of the difference of the two vectors
    double allowance; ///< m/s, the most by which gravity and friction can change it in this step
    /// Rigid model only:
    double friction;   ///< mu
    double impulse;    ///< per mass, m/s: -(1+e) vn
    double slip;       ///< of the contact point, m/s
    double tangential; ///< impulse jt, m/s
    bool sticks;       ///< jt removed all slip
};
TangentialLaw tangentialLaw(const LoggedEvent &bounce, double radius);

/// Where the ball was when it bounced. A step reports only the time: the position follows from the state before the
/// step and the normal speeds at both ends of the time between, provided that nothing else happened first.
struct BouncePlace {
    double gap;         ///< m from the box; negative: overlapping it
    double uncertainty; ///< m: 0 at a step's beginning, else from a changing acceleration
    double lateness;    ///< s, to first order: negative if the step bounced the ball before it reached the box
                        ///< (model.md 13.5)
    bool isAtFace(double radius) const;
};
std::optional<BouncePlace> bouncePlace(const LoggedEvent &bounce, double radius);

/// One line of the explanation.
struct LawLine {
    QString label;
    QString text;
};
/// For display: the laws with numbers and units, and how well they are satisfied. Empty for an event that isn't a
/// bounce.
std::vector<LawLine> lawLines(const LoggedEvent &bounce, double radius);

} // namespace inspector
