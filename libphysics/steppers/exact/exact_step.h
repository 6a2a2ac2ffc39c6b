// SPDX-License-Identifier: MIT
// One step of the exact stepper: from event to event until the time is up, model.md 8.
#pragma once

#include "contact/contact.h"
#include "contact/modes.h"
#include "exact/resisted.h"
#include "exact/search.h"
#include "exact/series.h"
#include "exact/slide.h"
#include "exact/uniform.h"
#include "registry/report.h"
#include "shared/floor_region.h"

#include <variant>

namespace phys {

using Phase = std::variant<Uniform, Resisted, Slide, Series>;

class ExactStep {
public:
    ExactStep(const Scene &scene, FloorRegions &regions, const phys_params &params, double dt, const phys_state &in,
              phys_report *report, phys_error *err);

    /// Fills everything but the time and the number of the step.
    phys_status advance(phys_state &out);

private:
    /// Sine of the angle between normals, or of one and a plane, below which they are parallel but for rounding.
    static constexpr double kParallel = 1e-12;
    static constexpr uint32_t kManyBoxes = 0xffffffff;

    /// What the ball may meet beside a face lies behind the plane of its nearest point.
    struct Obstacle {
        Vec3 normal;
        double gap; ///< m, less all that the ball moves along the face's normal
    };
    using Obstacles = ShortList<Obstacle>;

    struct BounceSeries;
    /// Of a series of bounces, from its start on.
    struct SeriesPart {
        double time;
        double squares; ///< s^2: sum of the squares of the flights' times
        double speed;   ///< at its end, from the face
    };

    const Scene &m_scene;
    FloorRegions &m_regions;
    const phys_params &m_params;
    Setting m_setting;
    Reporter m_report;
    phys_error *m_err;
    Work m_work;
    double m_left;          // s of the step still to go
    double m_elapsed = 0.0; // s of the step gone by
    double m_orientation[4];

    Vec3 m_position;
    Motion m_motion;
    Contacts m_contacts;                       // touched now
    std::array<uint32_t, kMostHeld> m_lasting; // of them, those without a velocity across
    std::array<Held, kMostHeld> m_held;        // the same for the law
    uint32_t m_heldCount = 0;
    Response m_response;
    bool m_isAnswered = false; // m_response is that of the present contacts
    double m_openWay = 0.0;    // m that the ball surely goes no further than in this step, if nothing stops it
    uint32_t m_nearBoxes = 0;  // that it can reach on this way
    const FloorRegion *m_region = nullptr; // that the ball starts in
    ShortList<uint32_t> m_ground;          // all boxes that it touches there
    bool m_supported = false;              // reported last
    uint32_t m_wall = PHYS_NO_BOX;

    phys_status followEvents();
    phys_status checkWork() const;
    void findGround();
    bool staysOnGround(double acceleration) const;
    phys_status pushOut();
    void leave(phys_state &out);

    void resolve();
    void touch();
    bool movesAlongFaces() const;
    bool movesAlongGround() const;
    void keepFaces();
    void holdGround();
    void takeFaces();
    void takeEdges();
    void stopBounces(double negligible);
    bool isApproaching(double negligible) const;
    bool collide(double negligible);
    const Contact *nextBounce() const;
    void skipBounces();
    void makeBounces(double back, const Obstacles &obstacles);
    bool endsSlips(const Contact &face) const;
    bool isRegular(const Contact &face) const;
    bool skipSeries(const Obstacles &obstacles);
    bool endSeries(const Obstacles &obstacles);
    double freeTime(const BounceSeries &series, const Obstacles &obstacles) const;
    void followSeries(const BounceSeries &series, const SeriesPart &part);
    Obstacles findObstacles(const Contact &face, double height);
    bool isClear(const Obstacles &obstacles, const Vec3 &gone, const Vec3 &way, const Vec3 &bend) const;
    void endBounces(double negligible);
    Vec3 actingAcceleration();
    double lastBounce(const Contact &contact, const Vec3 &acting) const;
    bool endsAsSeries(const Contact &face) const;
    double lastHeight() const;
    double higher() const;
    void collectHeld(double negligible);
    void addHeld(uint32_t number);
    double squareOfFastBounce() const;
    bool areBouncing() const;
    bool holdNext(double negligible);
    void hold(double negligible);
    bool crosses(const Vec3 &first, const Vec3 &second, const Vec3 &along) const;
    void project();
    bool isCarried(double negligible) const;
    void roll(bool isImpact);
    Moment moment() const;

    void keepFixed();
    void stopHeld();
    phys_status choose(Phase &phase);
    bool rollsOn(Phase &phase);
    bool turnsAgainst(const Vec3 &drive, double resistance) const;
    phys_status respondNow();
    phys_status jam();
    void takeJammed(const Moment &jammed);
    bool isUniform(const Vec3 &free) const;
    bool isAlone(uint32_t &closed) const;
    bool slides(Slide::Faces &faces) const;
    bool isStill() const;
    bool restsNow() const;
    void buildSeries(Series &series);
    uint32_t countSticking() const;
    bool startsBeside(const Response &response) const;
    void withoutResistance(uint32_t slipping);
    void noteContacts();

    template<class P>
    End firstEvent(const P &phase, Border &border);
    template<class P>
    End ownEnd(const P &phase, double until);
    template<class P>
    void follow(const P &phase, const End &end, const Border &border);
    bool isOpen(double acceleration) const;
    void settle(const End &end, const Border &border);
    void turnNormals();
    void keepContacts();
    void clearSlips(const End &end, double rounding);
    bool sticks(uint32_t i, const End &end) const;
    void rollOn(uint32_t i, double rounding);
    bool stick(uint32_t i, double most);
    template<class P>
    void turn(const P &phase, double t);

    std::span<const Held> held() const { return {m_held.data(), m_heldCount}; }
    const Contact &contactOf(uint32_t held) const { return m_contacts[m_lasting[held]]; }
    bool runsAllStages() const { return (m_params.options & PHYS_OPTION_ALL_STAGES) != 0; }
    bool isOnGround() const { return m_ground.count() > 0; }
    bool isClosed(uint32_t held) const { return m_response.reactions[held].mode != Mode::open; }
    uint32_t closedBits() const;
    void event(uint32_t kind, double before, double after);
};

} // namespace phys
