// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

namespace inspector {

namespace {

constexpr double kTimed = 0.002;    ///< s, minimum; short runs are repeated so that the clock's own cost is negligible
constexpr size_t kLegsPerLook = 64; ///< legs between two checks for a stop

double cpuTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// The angle of the rotation between two orientations, rad. Computed from their difference, because the cosine is
/// insensitive to small angles.
double angleBetween(const double (&a)[4], const double (&b)[4]) {
    double minus = 0.0;
    double plus = 0.0;
    for (size_t i = 0; i < 4; ++i) {
        minus += (a[i] - b[i]) * (a[i] - b[i]);
        plus += (a[i] + b[i]) * (a[i] + b[i]); // a quaternion and its negative are the same rotation
    }
    return 4.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(std::min(minus, plus))));
}

/// A ball moved by the stepper under test, and its reports.
class TestedBall {
public:
    explicit TestedBall(const TradeRun &run, QString *note)
        : m_stepper(makeStepper(run.registry, run.stepper, run.scene, note))
        , m_params(run.params)
        , m_radius(phys_scene_radius(run.scene.get())) {
        phys_scene_start(run.scene.get(), &m_state);
        phys_report_init(&m_report, sizeof m_report);
        m_report.events = m_events.data();
        m_report.event_capacity = uint32_t(m_events.size());
    }

    bool isReady() const { return m_stepper != nullptr; }

    bool advance(const Leg &leg, const phys_vec3 &gravity, QString *note) {
        m_params.gravity = gravity;
        for (uint32_t i = 0; i < leg.steps; ++i) {
            phys_error failure;
            if (phys_step(m_stepper.get(), &m_params, leg.dt, &m_state, &m_state, &m_report, &failure) != PHYS_OK) {
                *note = QStringLiteral("ends at %1 s: %2")
                            .arg(m_state.time, 0, 'f', 3)
                            .arg(QString::fromUtf8(failure.text));
                return false;
            }
            appendImpacts(m_report, m_impacts);
            m_error.energyDrift += m_report.energy_scheme;
            m_error.penetrationLargest = std::max(m_error.penetrationLargest, m_report.penetration / m_radius);
        }
        return true;
    }

    void compare(double time, const phys_state &expected) {
        const double position = distance(m_state.position, expected.position) / m_radius;
        if (position > m_error.positionLargest) m_error.growth.push_back({time, position});
        if (position > kWrong && !m_error.timeUntilWrong) m_error.timeUntilWrong = time;
        m_error.positionFinal = position;
        m_error.positionLargest = std::max(m_error.positionLargest, position);
        m_error.velocityLargest = std::max(m_error.velocityLargest, distance(m_state.velocity, expected.velocity));
        if (!(m_params.options & PHYS_OPTION_ORIENTATION)) return;
        const double turn = angleBetween(m_state.orientation, expected.orientation);
        m_error.orientationLargest = std::max(m_error.orientationLargest.value_or(0.0), turn);
    }

    const std::vector<Impact> &impacts() const { return m_impacts; }
    TradeError takeError() { return std::move(m_error); }

private:
    Stepper m_stepper;
    phys_params m_params;
    double m_radius;
    phys_state m_state{};
    std::array<phys_event, 256> m_events;
    phys_report m_report{};
    std::vector<Impact> m_impacts;
    TradeError m_error;
};

std::vector<Impact> impactsUntil(std::vector<Impact> impacts, double time) {
    std::erase_if(impacts, [time](const Impact &impact) { return impact.time > time; });
    return impacts;
}

} // namespace

phys_params paramsFor(const TradePlan &plan, uint32_t model) {
    phys_params params = plan.inputs.params;
    params.model = model;
    params.options &= ~uint32_t(PHYS_OPTION_ORIENTATION);
    if (plan.withOrientation) params.options |= PHYS_OPTION_ORIENTATION;
    return params;
}

TradeRun runOf(const TradePlan &plan, const TradePoint &point) {
    phys_params params = paramsFor(plan, point.model);
    phys_stepper_info info;
    if (phys_registry_find(plan.registry.get(), point.stepper.constData(), &info, nullptr) == PHYS_OK)
        phys_stepper_info_init_params(&info, &params);
    params.model = point.model;
    return {plan.registry, plan.scene, point.stepper, params};
}

ReferenceMotion motionOf(const TradeReference &reference, double dt, double until) {
    std::vector<Leg> legs = legsOf(reference.segments(), dt);
    std::vector<phys_state> states = reference.statesAt(legs);
    return {reference.segments(), std::move(legs), std::move(states), impactsUntil(reference.impacts(), until), until};
}

TradeError compareRun(const TradeRun &run, const ReferenceMotion &motion, const std::stop_token &stop, QString *note) {
    TestedBall tested(run, note);
    if (!tested.isReady()) return {};
    for (size_t i = 0; i < motion.states.size() && !stop.stop_requested(); ++i) {
        const Leg &leg = motion.legs[i];
        if (leg.end > motion.until * (1.0 + 1e-12)) break;
        if (!tested.advance(leg, motion.segments[leg.segment].gravity, note)) break;
        tested.compare(leg.end, motion.states[i]);
    }
    TradeError error = tested.takeError();
    error.wrongImpacts = wrongImpacts(motion.impacts, tested.impacts());
    return error;
}

std::optional<double> timeRun(const TradeRun &run, const std::vector<TiltSegment> &segments,
                              const std::vector<Leg> &legs, const std::stop_token &stop) {
    const Stepper stepper = makeStepper(run.registry, run.stepper, run.scene, nullptr);
    if (!stepper) return std::nullopt;
    phys_state start;
    phys_scene_start(run.scene.get(), &start);
    phys_params params = run.params;
    int runs = 0;
    const double begin = cpuTime();
    for (; runs == 0 || cpuTime() - begin < kTimed; ++runs) {
        phys_state state = start;
        for (size_t i = 0; i < legs.size(); ++i) {
            if (i % kLegsPerLook == 0 && stop.stop_requested()) return std::nullopt;
            const Leg &leg = legs[i];
            params.gravity = segments[leg.segment].gravity;
            for (uint32_t n = 0; n < leg.steps; ++n)
                if (phys_step(stepper.get(), &params, leg.dt, &state, &state, nullptr, nullptr) != PHYS_OK)
                    return std::nullopt;
        }
    }
    return (cpuTime() - begin) / runs;
}

} // namespace inspector
