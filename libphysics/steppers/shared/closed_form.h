// SPDX-License-Identifier: MIT
// Closed forms of the smooth phases between two events: model.md 3.
#pragma once

#include "base/vec.h"

#include <limits>

namespace phys {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// Euclidean length without underflow or overflow; the same bits for (x, y) and (y, x).
double length(const Vec2 &v);

/// First h >= 0 at which gap + rate h + acceleration h^2 / 2 falls through zero; kNever if there is none. gap >= 0.
double firstFall(double gap, double rate, double acceleration);

/// The law v' = A - B v/|v| of a rolling or slipping ball, model.md 3.1, from v0 at x = 0, t = 0. Everything is
/// expressed by integrals of exponentials of xi = integral of dt/|v|.
class ResistedLaw {
public:
    struct Point {
        Vec2 x, v; ///< displacement and velocity
    };

    ResistedLaw() = default;
    ResistedLaw(const Vec2 &v0, const Vec2 &A, double B);

    /// The state of a ball from v0 after t seconds; false if it rests at the start or stops by then.
    static bool goesOn(const Vec2 &v0, const Vec2 &A, double B, double t, Point &out);

    /// When the ball stops, model.md 3.2; kNever if it doesn't.
    double stopTime() const { return m_stopTime; }

    /// The state after t seconds; from the stop time on: the place of the stop.
    Point at(double t) const;
    /// The length of the way until then, m.
    double pathUntil(double t) const;

private:
    Vec2 m_v0{0.0, 0.0};
    double m_a = 0.0, m_B = 0.0;         // |A|, B
    double m_speed = 0.0, m_drive = 0.0; // |v0|, A.v0
    Vec2 m_e{1.0, 0.0};                  // direction of A (of v0 if A = 0)
    double m_P = 0.0, m_M = 0.0;         // (|v0| + v0.e)/2, (|v0| - v0.e)/2
    double m_vt = 0.0;                   // component of v0 across e
    double m_stopTime = kNever;
    bool m_fromRest = false;

    struct Passed;
    struct Shares;

    void begin(const Vec2 &v0, const Vec2 &A, double B);
    double shortXi(double t) const;
    template<class Of>
    Passed improve(double xi, double t) const;
    bool isLast(const Passed &passed) const;
    bool passShortTime(double t, Passed &out) const;
    Passed passAnyTime(double t) const;
    Shares sharesAt(const Passed &passed, double t) const;
    template<class Of>
    Point atXi(const Passed &passed, double t) const;
    template<class Of>
    double pathAtXi(const Passed &passed, double t) const;
    Point atStop() const;
    double pathToStop() const;
};

} // namespace phys
