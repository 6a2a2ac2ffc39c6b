// SPDX-License-Identifier: MIT
// One step of the exact stepper: from event to event until the time is up, model.md 8.
#pragma once

#include "exact/bounces.h"
#include "exact/resolve.h"
#include "phases/resisted.h"
#include "phases/series.h"
#include "phases/slide.h"
#include "phases/uniform.h"

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
    MovingBall m_ball;
    Ground m_ground;
    Touching m_touching;
    Response m_response;
    bool m_isAnswered = false; // m_response is that of the present contacts
    bool m_supported = false;  // reported last
    uint32_t m_wall = PHYS_NO_BOX;

    phys_status followEvents();
    void resolveMoment();
    phys_status pushOut();
    void leave(phys_state &out);

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
    void settle(const End &end, const Border &border);
    void turnNormals();
    void keepContacts();
    void clearSlips(const End &end, double rounding);
    bool sticks(uint32_t i, const End &end) const;
    void rollOn(uint32_t i, double rounding);
    bool stick(uint32_t i, double most);

    bool isClosed(uint32_t held) const { return m_response.reactions[held].mode != Mode::open; }
    uint32_t closedBits() const;
};

} // namespace phys
