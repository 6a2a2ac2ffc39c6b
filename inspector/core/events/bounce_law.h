// SPDX-License-Identifier: GPL-3.0-or-later
// What the model asks of a bounce, with the numbers of one bounce put in, and how well they obey. Sections are those of
// libphysics/docs/model.md.
#pragma once

#include "core/events/event_log.h"

#include <QString>

#include <optional>
#include <vector>

namespace inspector {

// The coefficients of the surface that it bounces off.
double restitutionOf(const LoggedEvent &bounce);
double frictionOf(const LoggedEvent &bounce); // of the rigid model

// Components of the ball's velocity and spin at the contact.
struct Motion {
    double normal;          // m/s, along the normal
    phys_vec3 tangential;   // m/s, in the tangent plane
    double tangentialSpeed; // its length
    phys_vec3 spin;         // rad/s
};
Motion motionOf(const phys_state &state, const phys_vec3 &normal);

// v'n = -e vn. The report's own speeds, right before and after.
struct NormalLaw {
    double restitution;
    double before;    // m/s, towards the box, >= 0
    double expected;  // m/s
    double found;     // m/s
    bool ends;        // found 0 instead: the stepper counts so slow a bounce as contact (6.4, 10.3)
    double deviation; // share of `before`
};
NormalLaw normalLaw(const LoggedEvent &bounce);

// Across the normal: unchanged in the rolling model (R2, R6); in the rigid one Coulomb's impulse (F3). Steps report no
// tangential speeds: these are those of the states before and after the step, with all else that happened in it.
struct TangentialLaw {
    double expected;  // m/s
    double found;     // m/s
    double off;       // m/s, length of the difference of the two as vectors
    double allowance; // m/s that gravity and friction can do to it in this step
    // Rigid model only:
    double friction;   // mu
    double impulse;    // per mass, m/s: -(1+e) vn
    double slip;       // of the contact point, m/s
    double tangential; // impulse jt, m/s
    bool sticks;       // jt took all the slip
};
TangentialLaw tangentialLaw(const LoggedEvent &bounce, double radius);

// Where the ball was when it bounced. A step reports only when that was: the place follows from the state before the
// step and the normal speeds at both ends of the time between, for which nothing else may have happened first.
struct BouncePlace {
    double gap;         // m from the box; negative: overlapping it
    double uncertainty; // m: none at a step's beginning, else what a changing acceleration can do
    double lateness;    // s, to first order: negative where the step bounced the ball ahead of the box (model.md 13.5)
    bool isAtFace(double radius) const;
};
std::optional<BouncePlace> bouncePlace(const LoggedEvent &bounce, double radius);

// One line of the explanation.
struct LawLine {
    QString label;
    QString text;
};
// For people: the laws with numbers and units, and how well they are obeyed. Empty for an event that isn't a bounce.
std::vector<LawLine> lawLines(const LoggedEvent &bounce, double radius);

} // namespace inspector
