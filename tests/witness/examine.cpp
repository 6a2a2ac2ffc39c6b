// SPDX-License-Identifier: MIT
#include "examine.h"

#include "converge.h"
#include "free_space.h"
#include "integrator/touch.h"
#include "split.h"

#include "support/handles.h"
#include "support/orders.h"
#include "support/state_difference.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>

namespace witness {

namespace {

using support::ScenePtr;
using support::StepperPtr;

constexpr uint32_t kEvents = 64;

/// A scene and a stepper for it, or the status with which they failed.
struct Engine {
    ScenePtr scene;
    StepperPtr stepper;
    phys_status status = PHYS_OK;
    std::string text;
};

Engine engineFor(const phys_registry *registry, const std::string &id, const std::vector<phys_box> &boxes,
                 double radius, const phys_vec3 &start) {
    Engine engine;
    const phys_scene_desc desc = descOf(boxes, radius, start);
    phys_error error{};
    phys_scene *scene = nullptr;
    phys_stepper *stepper = nullptr;
    engine.status = phys_scene_create(&desc, &scene, &error);
    engine.scene.reset(scene);
    if (!engine.status) engine.status = phys_stepper_create(registry, id.c_str(), scene, &stepper, &error);
    engine.stepper.reset(stepper);
    if (engine.status) engine.text = error.text;
    return engine;
}

/// A symmetry of the scene that the motion must follow to the bit.
struct Symmetry {
    const char *check;
    std::function<std::vector<phys_box>(const std::vector<phys_box> &)> boxes;
    std::function<phys_vec3(const phys_vec3 &)> place;    ///< of places, lengths
    std::function<phys_vec3(const phys_vec3 &)> velocity; ///< of velocities
    std::function<phys_vec3(const phys_vec3 &)> spin;     ///< of axial vectors
    std::function<phys_vec3(const phys_vec3 &)> gravity;
    double lengthScale = 1;
    double timeScale = 1;

    /// Whether the vector seen is that image. Subnormal components have no exact one in another scale.
    bool isSame(const phys_vec3 &image, const phys_vec3 &seen) const {
        const auto isEqual = [this](double a, double b) {
            return a == b || (lengthScale != 1 && std::max(std::abs(a), std::abs(b)) < DBL_MIN);
        };
        return isEqual(image.x, seen.x) && isEqual(image.y, seen.y) && isEqual(image.z, seen.z);
    }
};

phys_vec3 same(const phys_vec3 &v) { return v; }
std::vector<phys_box> mapped(const std::vector<phys_box> &boxes, phys_vec3 (*map)(const phys_vec3 &)) {
    std::vector<phys_box> result;
    for (const phys_box &box : boxes) {
        const phys_vec3 a = map(box.min);
        const phys_vec3 b = map(box.max);
        result.push_back({{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}});
    }
    return result;
}

phys_vec3 mirror(const phys_vec3 &v) { return {-v.x, v.y, v.z}; }
phys_vec3 mirrorAxial(const phys_vec3 &v) { return {v.x, -v.y, -v.z}; }
phys_vec3 quarter(const phys_vec3 &v) { return {-v.y, v.x, v.z}; }
phys_vec3 swap(const phys_vec3 &v) { return {v.y, v.x, v.z}; }
phys_vec3 swapAxial(const phys_vec3 &v) { return {-v.y, -v.x, -v.z}; }
phys_vec3 times4(const phys_vec3 &v) { return {4 * v.x, 4 * v.y, 4 * v.z}; }
phys_vec3 times2(const phys_vec3 &v) { return {2 * v.x, 2 * v.y, 2 * v.z}; }
phys_vec3 half(const phys_vec3 &v) { return {v.x / 2, v.y / 2, v.z / 2}; }

using Boxes = std::vector<phys_box>;

Boxes shuffled(const Boxes &boxes) {
    Boxes result(boxes.rbegin(), boxes.rend());
    std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(result.size() / 3), result.end());
    return result;
}
Boxes doubled(const Boxes &boxes) {
    Boxes result = boxes;
    result.insert(result.end(), boxes.begin(), boxes.end());
    return result;
}
/// Each box in two flush halves, across its longest side.
Boxes cut(const Boxes &boxes) {
    Boxes result;
    for (const phys_box &box : boxes) {
        phys_box low = box;
        phys_box high = box;
        const double x = box.max.x - box.min.x;
        const double y = box.max.y - box.min.y;
        const double z = box.max.z - box.min.z;
        if (x >= y && x >= z) {
            low.max.x = high.min.x = box.min.x + x / 2;
        } else if (y >= z) {
            low.max.y = high.min.y = box.min.y + y / 2;
        } else {
            low.max.z = high.min.z = box.min.z + z / 2;
        }
        result.push_back(low);
        result.push_back(high);
    }
    return result;
}

std::vector<Symmetry> symmetries() {
    const auto by = [](phys_vec3 (*map)(const phys_vec3 &)) {
        return [map](const Boxes &boxes) { return mapped(boxes, map); };
    };
    return {
        {"mirrored", by(mirror), mirror, mirror, mirrorAxial, mirror},
        {"turned", by(quarter), quarter, quarter, quarter, quarter},
        {"swapped", by(swap), swap, swap, swapAxial, swap},
        {"scaled", by(times4), times4, times2, half, same, 4, 2},
        {"shuffled", shuffled, same, same, same, same},
        {"doubled", doubled, same, same, same, same},
        {"cut", cut, same, same, same, same},
    };
}

bool equal(const phys_vec3 &a, const phys_vec3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool isFinite(const phys_vec3 &v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// CPU time of this thread, s, so that others don't count.
double cpuTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Observation {
    phys_status status;
    phys_state out;
    phys_error error;
};

class Examination {
public:
    Examination(const phys_registry *registry, const std::string &id, const Case &scene)
        : m_registry(registry)
        , m_id(id)
        , m_scene(scene)
        , m_space(scene.boxes, scene.radius)
        , m_engine(engineFor(registry, id, scene.boxes, scene.radius, scene.start.position))
        , m_symmetries(symmetries())
        , m_isExact(support::ordersOf(id).impacts == 0)
        , m_params(scene.params) {
        for (const Symmetry &symmetry : m_symmetries) {
            m_images.push_back(engineFor(registry, id, symmetry.boxes(scene.boxes), symmetry.lengthScale * scene.radius,
                                         symmetry.place(scene.start.position)));
        }
        phys_stepper_info info;
        if (phys_registry_find(registry, id.c_str(), &info, nullptr) == PHYS_OK) {
            phys_stepper_info_init_params(&info, &m_params);
        }
        for (const phys_box &box : scene.boxes) {
            for (const phys_vec3 &p : {box.min, box.max}) {
                m_largest = std::max({m_largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
            }
        }
        phys_report_init(&m_report, sizeof m_report);
        m_report.events = m_events.data();
        m_report.event_capacity = kEvents;
    }

    Verdict run() {
        m_verdict.status = m_engine.status;
        m_verdict.statusText = m_engine.text;
        checkImagesOfCreation();
        if (m_engine.status) return m_verdict;
        phys_state state = m_scene.start;
        for (const Leg &leg : m_scene.legs) {
            bool isDone = false; // a step that fails ends its leg
            for (uint32_t i = 0; i < leg.steps && !isDone && m_verdict.check.empty(); ++i) {
                isDone = !step(leg, state);
            }
        }
        return m_verdict;
    }

private:
    /// The first failure is the verdict, as later ones may be consequences of it.
    [[gnu::format(printf, 3, 4)]] void complain(const char *check, const char *format, ...) {
        if (!m_verdict.check.empty()) return;
        char text[300];
        va_list arguments;
        va_start(arguments, format);
        std::vsnprintf(text, sizeof text, format, arguments);
        va_end(arguments);
        m_verdict.check = check;
        m_verdict.what = text;
        m_verdict.step = m_verdict.steps;
    }

    /// False if it failed; `state` is unchanged then.
    bool step(const Leg &leg, phys_state &state) {
        const phys_state in = state;
        m_params.gravity = leg.gravity;
        const phys_report untouched = m_report;
        phys_state out;
        std::memset(&out, 0x5a, sizeof out);
        const phys_state pattern = out;
        phys_error error{};
        const double begin = cpuTime();
        const phys_status status = phys_step(m_engine.stepper.get(), &m_params, leg.dt, &in, &out, &m_report, &error);
        m_verdict.seconds = std::max(m_verdict.seconds, cpuTime() - begin);
        if (status && !m_verdict.status) {
            m_verdict.status = status;
            m_verdict.statusText = error.text;
            m_verdict.step = m_verdict.steps;
        }
        if (status) {
            // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): no padding
            if (std::memcmp(&out, &pattern, sizeof out) != 0) complain("untouched", "a failed step wrote its state");
            // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): no padding
            if (std::memcmp(&m_report, &untouched, sizeof m_report) != 0) {
                complain("untouched", "a failed step wrote its report");
            }
            if (error.status != status || !error.text[0]) complain("untouched", "a failed step without a reason");
        }
        if (!status) checkNumbers(leg, in, out);
        if (!m_verdict.check.empty()) return false;
        if (!status) checkPlace(leg, in, out);
        if (!status) checkEnergy(leg, in, out);
        checkRepeats(leg, in, status, out);
        if (!status && m_isExact) checkParts(leg, in);
        checkImages(leg, in, status, out);
        if (status) return false;
        checkReport(leg, in, out);
        checkFlags(leg, in, out);
        ++m_verdict.steps;
        state = out;
        return true;
    }

    // ------------------------------------------------------------------------------------------------------- bits --

    Observation observe(phys_stepper *stepper, double dt, const phys_params &params, const phys_state &in) const {
        Observation result{};
        result.out = in;
        result.status = phys_step(stepper, &params, dt, &result.out, &result.out, nullptr, &result.error);
        return result;
    }

    /// Repeats the step with a new stepper, without a report, in place; then with every stage forced.
    void checkRepeats(const Leg &leg, const phys_state &in, phys_status status, const phys_state &out) {
        phys_stepper *created = nullptr;
        if (phys_stepper_create(m_registry, m_id.c_str(), m_engine.scene.get(), &created, nullptr)) {
            complain("fresh", "the second stepper for a scene can't be made");
        }
        const StepperPtr fresh(created);
        phys_params params = m_params;
        for (const uint32_t option : {0U, uint32_t(PHYS_OPTION_ALL_STAGES)}) {
            params.options |= option;
            const char *check = option ? "all_stages" : "fresh";
            const Observation again = observe(fresh.get(), leg.dt, params, in);
            if (again.status != status) {
                complain(check, "%s, then %s", phys_status_name(status), phys_status_name(again.status));
            } else if (!status && std::memcmp(&again.out, &out, sizeof out) != 0) { // NOLINT
                complain(check, "other bits: %s", support::firstDifference(out, again.out).c_str());
            }
        }
    }

    /// For a stepper without a step-size error.
    void checkParts(const Leg &leg, const phys_state &in) {
        constexpr double kAmplified = 1e3; // a motion may be more sensitive in a direction that isn't tried
        const std::optional<SplitDifference> difference =
            splitDifference(m_engine.stepper.get(), m_params, leg.dt, in, m_scene.radius);
        if (!difference || difference->apart <= 1e-8 * m_scene.radius + kAmplified * difference->spread) return;
        const auto isUndecided = [&](const phys_vec3 &centre) { return hasUndecidedGap(m_scene, centre); };
        if (std::any_of(difference->places.begin(), difference->places.end(), isUndecided)) return;
        if (passesThroat(m_scene, difference->places)) return;
        complain("split", "in three parts the step of %.3g s leads %.3g m away; a start off by 1e-12 makes %.3g m",
                 leg.dt, difference->apart, difference->spread);
    }

    void checkImagesOfCreation() {
        for (size_t i = 0; i < m_images.size(); ++i) {
            if (m_images[i].status == m_engine.status) continue;
            complain(m_symmetries[i].check, "made with %s, its image with %s (%s)", phys_status_name(m_engine.status),
                     phys_status_name(m_images[i].status), m_images[i].text.c_str());
        }
    }

    void checkImages(const Leg &leg, const phys_state &in, phys_status status, const phys_state &out) {
        for (size_t i = 0; i < m_images.size(); ++i) {
            const Symmetry &symmetry = m_symmetries[i];
            phys_state image = in;
            image.position = symmetry.place(in.position);
            image.velocity = symmetry.velocity(in.velocity);
            image.spin = symmetry.spin(in.spin);
            phys_params params = m_params;
            params.gravity = symmetry.gravity(leg.gravity);
            const Observation seen = observe(m_images[i].stepper.get(), symmetry.timeScale * leg.dt, params, image);
            if (seen.status != status) {
                complain(symmetry.check, "%s, its image %s", phys_status_name(status), phys_status_name(seen.status));
                continue;
            }
            if (status) continue;
            const bool isSame = symmetry.isSame(symmetry.place(out.position), seen.out.position) &&
                                symmetry.isSame(symmetry.velocity(out.velocity), seen.out.velocity) &&
                                symmetry.isSame(symmetry.spin(out.spin), seen.out.spin) && seen.out.flags == out.flags;
            if (isSame) continue;
            const Real off = length(vectorOf(seen.out.position) - vectorOf(symmetry.place(out.position)));
            complain(symmetry.check, "its image differs: by %.3g m, flags %llx and %llx", static_cast<double>(off),
                     static_cast<unsigned long long>(out.flags), static_cast<unsigned long long>(seen.out.flags));
        }
    }

    // ------------------------------------------------------------------------------------------------- one result --

    void checkNumbers(const Leg &leg, const phys_state &in, const phys_state &out) {
        if (!isFinite(out.position) || !isFinite(out.velocity) || !isFinite(out.spin)) {
            complain("finite", "a number that isn't finite");
        }
        const double elapsed = out.time - in.time - leg.dt;
        if (out.step != in.step + 1 || std::abs(elapsed) > 1e-15 * (1 + out.time)) {
            complain("finite", "time or step miscounted");
        }
    }

    double depthAt(const phys_vec3 &place) const {
        Real deepest = 0;
        for (const phys_box &box : m_scene.boxes) {
            deepest = std::max(deepest, -touchOf(box, vectorOf(place), m_scene.radius).gap);
        }
        return static_cast<double>(deepest);
    }

    double roundingOf(const phys_vec3 &place) const {
        const double largest = std::max({m_largest, std::abs(place.x), std::abs(place.y), std::abs(place.z)});
        return 32 * 2.2e-16 * largest + 1e-13 * m_scene.radius;
    }

    /// No path is longer than this: contacts only reduce the speed, so |V| grows by |g| dt at most, V^2 = 2 E_kinetic.
    double reach(const Leg &leg, const phys_state &in) const {
        const double v = static_cast<double>(length(vectorOf(in.velocity)));
        const double w = m_scene.radius * static_cast<double>(length(vectorOf(in.spin)));
        const double g = static_cast<double>(length(vectorOf(leg.gravity)));
        const double speed = std::sqrt(v * v + 0.4 * std::max(w * w, v * v));
        return 1.01 * leg.dt * (speed + g * leg.dt) + 2 * depthAt(in.position) + 0.01 * m_scene.radius;
    }

    void checkPlace(const Leg &leg, const phys_state &in, const phys_state &out) {
        const double depth = depthAt(out.position);
        const double allowed = roundingOf(out.position);
        if (depth > allowed) complain("inside", "%.3g m deep in a box; allowed are %.3g m", depth, allowed);
        const double way = reach(leg, in);
        const double moved = static_cast<double>(length(vectorOf(out.position) - vectorOf(in.position)));
        const bool startsFree = depthAt(in.position) <= roundingOf(in.position);
        if (startsFree && moved > way)
            complain("too_far", "moved by %.6g m; the ball can't come further than %.6g m", moved, way);
        if (startsFree && !m_space.isReachable(in.position, out.position, way)) {
            complain("through", "from (%.9g, %.9g, %.9g) to (%.9g, %.9g, %.9g) there is no way around", in.position.x,
                     in.position.y, in.position.z, out.position.x, out.position.y, out.position.z);
        }
    }

    Real energyOf(const phys_state &state, const phys_vec3 &gravity) const {
        const Real turning = m_scene.radius * length(vectorOf(state.spin));
        return dot(vectorOf(state.velocity), vectorOf(state.velocity)) / 2 + turning * turning / 5 -
               dot(vectorOf(gravity), vectorOf(state.position));
    }

    /// Rounding of the energies involved. The ball is put to boxes that are a radius away from its centre.
    double energyNoise(const Leg &leg, const phys_state &in, const phys_state &out) const {
        Real largest = 0;
        for (const phys_state *state : {&in, &out}) {
            const Real turning = m_scene.radius * length(vectorOf(state->spin));
            largest = std::max(
                {largest, dot(vectorOf(state->velocity), vectorOf(state->velocity)), turning * turning,
                 length(vectorOf(leg.gravity)) * std::max<Real>(length(vectorOf(state->position)), m_scene.radius)});
        }
        return 1e-13 * static_cast<double>(largest);
    }

    /// How much energy a step may add: first-order steppers (force dt)^2 / 2 in flight; a ball that was given inside
    /// boxes is lifted, out of several boxes possibly by more than its depth in either; in the rolling model a landing
    /// may speed the spin up to v/R (model.md 9).
    void checkEnergy(const Leg &leg, const phys_state &in, const phys_state &out) {
        const double g = static_cast<double>(length(vectorOf(leg.gravity)));
        const double rise = static_cast<double>(energyOf(out, leg.gravity) - energyOf(in, leg.gravity));
        const double depth = depthAt(in.position);
        double allowed = energyNoise(leg, in, out) + 3 * g * depth;
        if (depth > roundingOf(in.position)) {
            allowed += g * static_cast<double>(length(vectorOf(out.position) - vectorOf(in.position)));
        }
        if (m_id != "exact" && m_id != "symplectic-euler") allowed += 0.51 * g * g * leg.dt * leg.dt;
        if (m_scene.params.model == PHYS_MODEL_ROLLING) {
            const double v = static_cast<double>(length(vectorOf(in.velocity))) + g * leg.dt;
            allowed += v * v / 5; // a landing, or a spin that wasn't that of rolling
        }
        if (g > 0) m_verdict.energyRise = std::max(m_verdict.energyRise, rise / (g * g * leg.dt * leg.dt));
        if (rise > allowed) complain("energy", "rose by %.6g J/kg; allowed are %.3g J/kg", rise, allowed);
    }

    void checkReport(const Leg &leg, const phys_state &in, const phys_state &out) {
        const phys_report &r = m_report;
        const double noise = 1e4 * energyNoise(leg, in, out); // a billionth of the energies involved
        const double parts[] = {r.energy_before, r.energy_after,  r.lost_impact, r.lost_rolling,
                                r.lost_slip,     r.energy_scheme, r.penetration};
        for (const double part : parts) {
            if (!std::isfinite(part)) complain("report", "a number that isn't finite");
        }
        const double left =
            r.energy_before + r.energy_scheme - r.energy_after - r.lost_impact - r.lost_rolling - r.lost_slip;
        const double size = std::abs(r.energy_before) + std::abs(r.energy_after) + std::abs(r.lost_impact) +
                            std::abs(r.lost_slip) + std::abs(r.lost_rolling);
        if (std::abs(left) > noise + 1e-12 * size) complain("report", "doesn't balance: %.3g J/kg are left", left);
        if (r.lost_impact < -noise || r.lost_rolling < -noise) {
            complain("report", "lost_impact %.3g, lost_rolling %.3g: losses below zero", r.lost_impact, r.lost_rolling);
        }
        if (m_scene.params.model == PHYS_MODEL_RIGID && r.lost_slip < -noise) {
            complain("report", "lost_slip %.3g: a loss below zero", r.lost_slip);
        }
        if (r.penetration < 0) complain("report", "penetration %.3g below zero", r.penetration);
        m_verdict.substeps = std::max(m_verdict.substeps, r.substeps);
        m_verdict.events = std::max(m_verdict.events, uint64_t{r.event_count} + r.events_lost);
        if (r.substep_cap && r.substeps > r.substep_cap)
            complain("effort", "%u substeps, the cap is %u", r.substeps, r.substep_cap);
        if (r.pass_cap && r.passes > r.pass_cap) complain("effort", "%u passes, the cap is %u", r.passes, r.pass_cap);
        if (r.event_count > kEvents) complain("report", "%u events in a buffer of %u", r.event_count, kEvents);
        for (uint32_t i = 0; i < std::min(r.event_count, kEvents); ++i) {
            const phys_event &event = m_events[i];
            if (event.time < in.time || event.time > out.time) {
                complain("report", "an event at %.17g s in a step from %.17g to %.17g s", event.time, in.time,
                         out.time);
            }
            if (i > 0 && event.time < m_events[i - 1].time) complain("report", "events out of order");
            if (event.box != PHYS_NO_BOX && event.box >= m_scene.boxes.size()) {
                complain("report", "an event with box %u", event.box);
            }
        }
    }

    void checkFlags(const Leg &leg, const phys_state &in, const phys_state &out) {
        (void)in;
        if (out.flags & PHYS_AT_REST) {
            if (!equal(out.velocity, {0, 0, 0})) complain("rest", "at rest, but moves");
            const Observation later = observe(m_engine.stepper.get(), leg.dt, m_params, out);
            if (!later.status && (!equal(later.out.position, out.position) || !equal(later.out.velocity, {0, 0, 0}))) {
                complain("rest", "at rest, but the next step moves it by %.3g m",
                         static_cast<double>(length(vectorOf(later.out.position) - vectorOf(out.position))));
            }
        }
        bool isOver = m_scene.boxes.empty();
        double low[2] = {1e300, 1e300};
        double high[2] = {-1e300, -1e300};
        for (const phys_box &box : m_scene.boxes) {
            low[0] = std::min(low[0], box.min.x), high[0] = std::max(high[0], box.max.x);
            low[1] = std::min(low[1], box.min.y), high[1] = std::max(high[1], box.max.y);
        }
        isOver = isOver || (out.position.x >= low[0] && out.position.x <= high[0] && out.position.y >= low[1] &&
                            out.position.y <= high[1]);
        if (!m_scene.boxes.empty() && isOver == ((out.flags & PHYS_OUT) != 0)) {
            complain("flags", "PHYS_OUT is wrong at (%.17g, %.17g)", out.position.x, out.position.y);
        }
    }

    const phys_registry *m_registry;
    const std::string &m_id;
    const Case &m_scene;
    FreeSpace m_space;
    Engine m_engine;
    std::vector<Symmetry> m_symmetries;
    bool m_isExact; ///< exact is the stepper, and the scene has an answer
    std::vector<Engine> m_images;
    phys_params m_params;
    double m_largest = 0.0;
    phys_report m_report{};
    std::array<phys_event, kEvents> m_events{};
    Verdict m_verdict;
};

} // namespace

const std::vector<std::string> &checkNames() {
    static const std::vector<std::string> kNames = {
        "inside", "through",   "too_far", "energy",  "finite", "fresh",    "all_stages",
        "split",  "mirrored",  "turned",  "swapped", "scaled", "shuffled", "doubled",
        "cut",    "untouched", "effort",  "report",  "rest",   "flags",    "law",
    };
    return kNames;
}

Verdict examine(const phys_registry *registry, const std::string &stepper, const Case &scene) {
    return Examination(registry, stepper, scene).run();
}

} // namespace witness
