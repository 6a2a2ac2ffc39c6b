// SPDX-License-Identifier: MIT
// The general phase: any lasting contacts with faces, edges and corners, smooth, sticking or slipping, as Taylor series
// in time. model.md 14.2.
#pragma once

#include "contact/dense.h"
#include "contact/mirror.h"
#include "contact/modes.h"
#include "phases/jet.h"
#include "phases/phase.h"

#include <utility>

namespace phys {

/// 1 along the axes in which closed contacts let the ball move, if they hold it to an axis or a point; otherwise 1
/// everywhere. Components in other directions are rounding, which nearly opposite normals amplify.
Vec3 freeAxes(const Moment &moment, std::span<const Held> held, const Response &response);

class Series {
public:
    /// Work of a look at the way.
    uint64_t lookWork() const { return m_countsSlips ? 110 : 60; }

    Series() {} // NOLINT(modernize-use-equals-default): a defaulted one may clear all terms

    /// unit: of the clock at the start, s. kept: bits of contacts that stick as long as others press them. wanted: how
    /// long the motion is asked for, s.
    void build(const Moment &moment, std::span<const Held> held, const Response &response, double unit, uint32_t kept,
               double wanted);

    /// The same for a slip so rough that its pressure follows the motion, model.md 14.2. False if there is none, or if
    /// the pressure is still on its way there.
    bool buildSlaved(const Moment &moment, std::span<const Held> held, const Response &response, double unit,
                     Work &work);
    /// The same for slips that grow or shrink so slowly that their directions follow the forces.
    bool buildTurning(const Moment &moment, std::span<const Held> held, const Response &response, double unit,
                      Work &work);
    /// s: in which slips change by as much as they are, if their directions follow the forces much faster; 0 if not.
    double timeOfSlips() const;

    /// Longest time for which the series are accurate to rounding, s; and in units of the clock.
    double horizon() const { return timeAt(m_reach.length); }
    double length() const { return m_reach.length; }
    double unit() const { return m_reach.unit; }
    /// Of the equations of an order: unknowns, and normals that turn.
    uint32_t size() const { return m_unknowns + m_turningNormals; }

    Way at(double t) const;
    Place placeAt(double t) const {
        const Way now = at(t);
        return {now.way, now.velocity, spinAt(t), m_mirror.backSpin(unit() * m_om.integralAt(t / unit()))};
    }
    Vec3 spinAt(double t) const;
    double least(const Vec3 &n, double rate, double t, double until) const;
    double mostAcceleration() const { return m_most; }
    std::array<double, kMostHeld> pressures(double t) const; ///< N of each contact
    /// Whether more contacts press than can by themselves, model.md 14.1.
    bool sharesLoad() const { return m_shared.rate != 0.0; }
    Losses losses(double t) const;

    /// How the phase itself ends before `until`.
    End end(double until, Work &work) const;

    /// Contacts whose force is zero and falling, so that they open now: bits.
    uint32_t opening() const;
    /// Contacts whose friction is spent and must still grow, so that they begin to slip without an acceleration: bits,
    /// and the directions of their slips.
    uint32_t spent(std::span<Vec3> slips) const;
    /// The same for two contacts together, and the forces with which they slip.
    uint32_t spentTogether(std::span<Reaction> reactions, std::span<Vec3> slips) const;
    /// Whether one of those slips would drive the ball.
    bool slipsBack(uint32_t spent) const;

private:
    struct Contact {
        Held held;
        Mode mode;
        bool isKept;
        bool isFlat;             ///< a face, whose normal never turns
        bool isIdle;             ///< isIdleBesideOther
        uint32_t partner;        ///< sticks while this one starts to slip, so across both normals
        VecJet n, u, d, r, free; ///< free: across both normals
        Jet N;
        Jet speed;      ///< of the slip, or of its quotient by the time if it starts
        Jet slowness;   ///< 1/speed
        Jet turn;       ///< d across its start, if it follows from forces
        bool isTurned;  ///< whether that is given
        double weight;  ///< of this slip in the independent variable, 1/s; 0: none
        Vec3 rateKnown; ///< rate of the slip at the present order without the contribution of the unknowns, if needed
        Vec3 directionKnown;
        uint32_t column = 0;

        /// Whether the equations are about the rate of the slip.
        bool needsRate() const { return mode != Mode::smooth && mode != Mode::slipping; }
        /// The last nonzero term of n up to k.
        int lastNormal(int k) const { return isFlat ? 0 : k; }
        /// Term k of n x b.
        Vec3 crossNormal(const VecJet &b, int k) const {
            Vec3 sum(0.0);
            for (int j = 0; j <= lastNormal(k); ++j) sum += glm::cross(n[j], b[k - j]);
            return sum;
        }
    };

    struct Reserve {
        Jet left;    ///< (m/s^2)^2
        double none; ///< a reserve that is zero up to rounding
    };

    Mirror m_mirror{Moment{}, {}};
    Moment m_moment;
    Vec3 m_free; ///< freeAxes
    std::array<Contact, kMostHeld> m_contacts;
    std::array<uint32_t, kMostHeld> m_index{};
    uint32_t m_count = 0, m_unknowns = 0, m_turningNormals = 0;
    uint32_t m_rolls = kMostHeld;       ///< the contact at which resistance acts
    uint32_t m_prestressed = kMostHeld; ///< of two that stick only so, the one with no friction left
    int m_last = kOrder;                ///< order of the last terms
    Reach m_reach;
    double m_valid = 0.0; ///< validSoFar
    double m_most = 0.0, m_noForce = 0.0;
    Vec3 m_turns{0.0}; ///< upper bound of the change of the acceleration along each axis per unit
    // The independent variable: the time, or with slips dt = w dsigma, so that it takes as long to halve them again and
    // again. model.md 14.2.
    bool m_countsSlips = false;
    Jet m_time;        ///< s
    Jet m_pace;        ///< w, 1 at the start
    Jet m_inversePace; ///< 1/w
    struct Known {
        double time, place;
    };
    mutable std::array<Known, 2> m_known; ///< the last times asked for: a search asks for each, and its end, again
    VecJet m_p, m_v, m_om, m_a, m_al;
    VecJet m_turning, m_rolling; ///< om_t, and its direction
    Jet m_turningSpeed;          ///< |om_t|, or its quotient by the time if the ball starts
    bool m_rollStarts = false;
    /// Three slipping contacts with normals in one plane that all press, or four that leave the ball no way: the forces
    /// that move the load among them and leave everything else as it is, model.md 14.1.
    struct Shared {
        uint32_t count = 0;
        std::array<uint32_t, 4> contacts;
        std::array<double, 4> pressures;
        Vec3 line{0.0}, push{0.0}, turn{0.0}; ///< along which three let the ball move; accelerations
        double rate = 0.0;                    ///< of what must remain zero; 0: there are none
        uint32_t idle = 0;                    ///< bits of those without pressure whose N remains 0
        bool isBarred = false;                ///< whether one of those leaves three no such line
    } m_shared;
    dense::Equations m_equations;                      ///< of the unknowns of an order
    mutable std::array<Reserve, kMostHeld> m_reserves; ///< those asked for: the start and the end of a phase ask
    mutable uint32_t m_knownReserves = 0;              ///< their bits

    uint32_t m_slaved = kMostHeld; ///< the contact whose N is given
    double m_given = 0.0;          ///< its present term
    bool m_isSlaved = false;       ///< some contact's N or direction is given

    struct {
        std::array<uint32_t, 2> contacts; ///< that have them
        std::array<Vec3, 2> starts;       ///< their directions at the start
        int count = 0;
        Vec2 fast, slow, fastRow, slowRow; ///< turns of both together, and what selects them
    } m_turned;

    std::span<Contact> contacts() { return {m_contacts.data(), m_count}; }
    std::span<const Contact> contacts() const { return {m_contacts.data(), m_count}; }
    uint32_t given(uint32_t i) const { return m_index[i]; }

    void take(const Moment &moment, std::span<const Held> held, const Response &response, double unit, uint32_t kept);
    void finish();
    bool findSlaved();
    bool relaxes(double present);
    double roundingOfPressure(const Contact &contact) const;
    double apart(const Contact &contact, int k) const;
    double apartWith(int k, double pressure);
    double apartAfter(int k, double pressure, double following);
    bool turnsFast(const Contact &contact) const;
    void turn(Contact &contact, int k);
    bool findFastTurn();
    Vec2 acrossDirections(int k) const;
    void setTurns(int k, double fast);
    double acrossAfter(int k, double fast, double following);
    template<class After>
    bool follow(const After &after, double present, double step, double nearly, double rounding, Work &work);
    void findPartners();
    void weighSlips();
    void findPace(int k);
    double timeAt(double s) const;
    double placeOf(double t) const;
    double integral(const Jet &rate, double s) const;
    void begin(const Response &response);
    void forces(int k);
    void knownForces(Contact &contact, int k);
    void knownAccelerations(int k);
    bool isIdleBesideOther(const Contact &contact) const;
    void solveOrder(int k);
    void keepIdle(const Vec3 &line, double rounding);
    void findShared();
    static Vec3 pushPer(const Contact &contact, int j);
    double imbalance(int k) const;
    void share(int k);
    void addGauge(uint32_t i, uint32_t j, int k, dense::Equations &equations);
    void addPrestress(const Contact &contact, int k, dense::Equations &equations) const;
    void addRows(const Contact &contact, int k, dense::Equations &equations) const;
    Vec3 basis(const Contact &contact, int part) const;
    Vec3 spinPerForce(const Contact &contact, const Vec3 &force, int k) const;
    void move(int k);
    void rollingDirection(int k);
    Vec3 steadied(const Vec3 &al, int k) const;
    void directions(Contact &contact, int k);
    double blindUntil() const;
    double validSoFar() const;
    bool suffices(double s);
    bool rolls(const Contact &contact) const { return m_rolls < m_count && &contact == &m_contacts[m_rolls]; }
    VecJet frictionOf(const Contact &contact) const;
    double frictionOfResistance(const Contact &contact) const;
    Vec3 resisting(const Contact &contact, int k) const;
    Vec3 rubbedPerPrestress(const Contact &contact, const Contact &other, double s) const;
    void findPrestressed(const Response &response);
    const Contact *otherSticking(const Contact &contact) const;
    const Reserve &reserveOf(const Contact &contact) const;
    Reserve findReserve(const Contact &contact) const;
    double shareOfRolling() const;
    bool isPrestressed(const Contact &contact) const;
    double endOfPrestress(double s, Work &work) const;
    bool takeReserve(const Contact &contact, const Contact &other, const VecJet &friction, Reserve &reserve) const;
    bool holdsUntil(const Contact &contact, double s) const;
    double noReserve(const Contact &contact, double pressure) const;
    Jet slipSpeed(const Contact &contact) const;
    bool startsToSlip(const Contact &contact) const;
    std::pair<Jet, double> startOfSlip(const Contact &contact) const;
    bool isIdle(const Contact &contact, double s) const;
};

} // namespace phys
