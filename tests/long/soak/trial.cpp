// SPDX-License-Identifier: MIT
#include "trial.h"

#include "walls.h"

#include "generator/recipe.h"
#include "support/handles.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <random>
#include <vector>

namespace soak {

namespace {

constexpr double kDeepest = 1e-12;     // m: rounding of a position in a maze of some decimetres, accumulated
constexpr double kEnergyNoise = 1e-13; // J/kg: rounding of energies of some 10 J/kg
constexpr uint64_t kStepsASide = 50;   // the tilt stays so long
constexpr uint64_t kReplayed = 500;    // every so many steps, the last ones are repeated by a fresh stepper
constexpr double kSteepest = 0.15;     // rad

using support::ScenePtr;
using support::StepperPtr;

/// SplitMix64 of a seed and a number: any number can be drawn at any time, so a replay needs no record.
uint64_t draw(uint64_t seed, uint64_t number) {
    uint64_t z = seed + (number + 1) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}
double draw(uint64_t seed, uint64_t number, double low, double high) {
    return low + (high - low) * (static_cast<double>(draw(seed, number) >> 11U) * 0x1p-53);
}

mazes::Maze mazeOf(uint64_t seed) {
    mazes::Recipe recipe;
    recipe.seed = seed;
    recipe.width = 4 + static_cast<int>(draw(seed, 1) % 8);
    recipe.height = 4 + static_cast<int>(draw(seed, 2) % 8);
    recipe.loopMillionths = static_cast<int64_t>(draw(seed, 3) % 1'000'000);
    return mazes::makeMaze(recipe);
}

double metres(mazes::Length length) { return static_cast<double>(length) * 1e-9; }
phys_vec3 metres(const mazes::Point &point) { return {metres(point[0]), metres(point[1]), metres(point[2])}; }

class Trial {
public:
    explicit Trial(const Plan &plan)
        : m_plan(plan)
        , m_walls(makeScene()) {
        m_stepper = makeStepper();
        phys_scene_start(m_scene.get(), &m_state);
        phys_params_init(&m_params, sizeof m_params);
        phys_stepper_info info;
        phys_registry_find(plan.registry, plan.stepper.c_str(), &info, nullptr);
        phys_stepper_info_init_params(&info, &m_params);
        const uint64_t seed = plan.seed;
        m_params.model = plan.model;
        m_params.restitution_wall = draw(seed, 10, 0.0, 1.0);
        m_params.rolling_friction = draw(seed, 11, 0.0, 0.02);
        m_params.sliding_friction = draw(seed, 12, 0.02, 0.5);
        m_params.wall_friction = draw(seed, 13) % 2 ? draw(seed, 14, 0.0, 0.5) : 0.0;
        const double dts[] = {0.0005, 0.001, 0.004, 0.01};
        m_dt = dts[draw(seed, 15) % 4];
        phys_report_init(&m_report, sizeof m_report);
    }

    Outcome run() {
        if (!m_stepper) return m_outcome;
        phys_state saved = m_state;
        while (goesOn()) {
            stepOnce();
            if (m_state.step - saved.step < kReplayed || !goesOn()) continue;
            replay(saved);
            saved = m_state;
        }
        return m_outcome;
    }

private:
    bool goesOn() const {
        return m_outcome.problem.empty() && m_outcome.declined.empty() && m_outcome.steps < m_plan.steps &&
               !(m_state.flags & PHYS_OUT);
    }

    Walls makeScene() {
        const mazes::Board board = mazeOf(m_plan.seed).board;
        std::vector<phys_box> boxes;
        for (const mazes::Box &box : board.boxes) boxes.push_back({metres(box.min), metres(box.max)});
        phys_scene_desc desc;
        phys_scene_desc_init(&desc, sizeof desc);
        desc.boxes = boxes.data();
        desc.box_count = static_cast<uint32_t>(boxes.size());
        desc.radius = metres(board.dimensions.ballRadius);
        desc.start = metres(board.start);
        phys_scene *scene = nullptr;
        phys_error error{};
        if (phys_scene_create(&desc, &scene, &error)) m_outcome.problem = error.text;
        m_scene.reset(scene);
        return {boxes, desc.radius, desc.start.z};
    }

    StepperPtr makeStepper() {
        phys_stepper *stepper = nullptr;
        phys_error error{};
        if (phys_stepper_create(m_plan.registry, m_plan.stepper.c_str(), m_scene.get(), &stepper, &error)) {
            m_outcome.problem = error.text;
        }
        return StepperPtr(stepper);
    }

    /// Parameters of a step, from its number alone.
    void tilt(uint64_t step) {
        const uint64_t side = 1000 + 2 * (step / kStepsASide);
        phys_gravity_from_tilt(draw(m_plan.seed, side, -kSteepest, kSteepest),
                               draw(m_plan.seed, side + 1, -kSteepest, kSteepest), 9.81, &m_params.gravity);
    }

    void stepOnce() {
        const phys_state before = m_state;
        phys_error error{};
        tilt(before.step);
        const phys_status status = phys_step(m_stepper.get(), &m_params, m_dt, &before, &m_state, &m_report, &error);
        const bool isDeclined = status == PHYS_ERROR_UNSUPPORTED || status == PHYS_ERROR_EVENT_CAP;
        if (status) (isDeclined ? m_outcome.declined : m_outcome.problem) = error.text;
        if (status) return;
        ++m_outcome.steps;
        m_outcome.impacts += m_report.events_lost; // no buffer: all events count as lost
        m_outcome.hash = draw(m_outcome.hash, phys_state_hash(&m_state));
        m_outcome.fastest = std::max(m_outcome.fastest, std::hypot(m_state.velocity.x, m_state.velocity.y));
        check(before);
    }

    void check(const phys_state &before) {
        const double depth = m_walls.depthAt(m_state.position);
        m_outcome.deepest = std::max(m_outcome.deepest, depth);
        if (depth > kDeepest) complain("%.3g m deep in a wall; allowed are %.3g m", depth, kDeepest);
        if (m_walls.areCrossed(before.position, m_state.position)) complain("went through a wall");

        const double gain = m_report.energy_after - m_report.energy_before;
        m_outcome.mostGained = std::max(m_outcome.mostGained, gain);
        const bool flies = (before.flags | m_state.flags) & PHYS_AIRBORNE;
        const double allowed = flies ? allowedInFlight() : allowedOnFloor();
        if (gain > allowed) complain("gained %.3g J/kg; allowed are %.3g J/kg", gain, allowed);
        if (m_state.step != before.step + 1) complain("the step isn't counted");
    }

    /// Energy grows at most by what a first-order scheme may add in a step, (5/14) (force dt)^2, and by lifting the
    /// ball against the tilt out of walls that it overlapped, once per pass: model.md 9, 10.1, 10.3.
    double allowedOnFloor() const {
        const double resistance =
            m_params.model == PHYS_MODEL_RIGID ? m_params.sliding_friction : m_params.rolling_friction;
        const double slope = std::hypot(m_params.gravity.x, m_params.gravity.y) - resistance * m_params.gravity.z;
        const double drift = 5.0 / 14.0 * (slope * m_dt) * (slope * m_dt);
        const double lift = m_report.penetration * m_report.passes * m_report.substeps;
        return drift + slope * lift + kEnergyNoise;
    }

    /// The same without the floor's 5/7: (force dt)^2 / 2.
    double allowedInFlight() const {
        const phys_vec3 &g = m_params.gravity;
        const double pull = (g.x * g.x + g.y * g.y) + g.z * g.z;
        return allowedOnFloor() + 0.5 * pull * m_dt * m_dt;
    }

    /// Repeats the steps since `saved` with a new stepper.
    void replay(const phys_state &saved) {
        const StepperPtr fresh = makeStepper();
        phys_state state = saved;
        for (uint64_t i = saved.step; i < m_state.step; ++i) {
            tilt(state.step);
            phys_step(fresh.get(), &m_params, m_dt, &state, &state, nullptr, nullptr);
        }
        if (phys_state_hash(&state) != phys_state_hash(&m_state)) complain("a fresh stepper gives other bits");
    }

    /// Keeps the first failure, as later ones may be consequences of it.
    [[gnu::format(printf, 2, 3)]] void complain(const char *format, ...) {
        if (!m_outcome.problem.empty()) return;
        char reason[200];
        va_list arguments;
        va_start(arguments, format);
        std::vsnprintf(reason, sizeof reason, format, arguments);
        va_end(arguments);
        char where[200];
        std::snprintf(where, sizeof where,
                      "step %llu at (%.9g, %.9g, %.9g), dt %g s: ", static_cast<unsigned long long>(m_state.step),
                      m_state.position.x, m_state.position.y, m_state.position.z, m_dt);
        m_outcome.problem = std::string(where) + reason;
    }

    const Plan &m_plan;
    Outcome m_outcome;
    ScenePtr m_scene;
    Walls m_walls;
    StepperPtr m_stepper;
    phys_state m_state{};
    phys_params m_params{};
    phys_report m_report{};
    double m_dt = 0.0;
};

} // namespace

Outcome run(const Plan &plan) { return Trial(plan).run(); }

std::string describe(const Plan &plan) {
    return std::string(plan.model == PHYS_MODEL_RIGID ? "rigid" : "rolling") + " model, stepper " + plan.stepper +
           ", seed " + std::to_string(plan.seed);
}

} // namespace soak
