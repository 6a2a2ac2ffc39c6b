// SPDX-License-Identifier: MIT
// libphysics through its public C interface: an engine for each stepper.
#include "peers/engine.h"
#include "support/board.h"

#include <algorithm>
#include <utility>

namespace bench {

namespace {

// The row of that id; nullptr if neither the library nor the stepper has it.
const phys_param_row *rowOf(const std::string &id, const phys_stepper_info &info) {
    uint32_t count = 0;
    const phys_param_row *rows = phys_param_rows(&count);
    for (uint32_t row = 0; row < count; ++row)
        if (id == rows[row].id) return &rows[row];
    for (uint32_t row = 0; row < info.row_count; ++row)
        if (id == info.rows[row]->id) return info.rows[row];
    return nullptr;
}

phys_params paramsOf(const Scene &scene, const phys_stepper_info &info, const std::vector<Setting> &settings) {
    phys_params params;
    phys_params_init(&params, sizeof params);
    phys_stepper_info_init_params(&info, &params);
    params.model = scene.rolls ? PHYS_MODEL_ROLLING : PHYS_MODEL_RIGID;
    params.restitution_wall = scene.restitution;
    params.rolling_friction = 0;
    params.sliding_friction = 0; // without friction on the floor the rigid ball slides: a = g_t
    params.wall_friction = 0;
    for (const Setting &setting : settings) {
        phys_error error;
        check(phys_param_set(&params, rowOf(setting.row, info), setting.value, &error), error);
    }
    return params;
}

class OurEngine final : public Engine {
public:
    OurEngine(const phys_stepper_info &info, const Scene &scene, const std::vector<Setting> &settings)
        : m_params(paramsOf(scene, info, settings))
        , m_scene(createScene(scene))
        , m_stepper(createStepper(info.id, *m_scene)) {
        phys_scene_start(m_scene.get(), &m_state);
    }

    void place(const Ball &ball) override {
        phys_scene_start(m_scene.get(), &m_state);
        m_state.position.x = ball.position.x;
        m_state.position.y = ball.position.y;
        m_state.velocity = {ball.velocity.x, ball.velocity.y, 0};
    }

    void setGravity(const phys_vec3 &gravity) override { m_params.gravity = gravity; }

    void advance(double dt, int steps) override {
        for (int step = 0; step < steps; ++step) {
            phys_error error;
            check(phys_step(m_stepper.get(), &m_params, dt, &m_state, &m_state, nullptr, &error), error);
        }
    }

    Ball ball() const override {
        return {{m_state.position.x, m_state.position.y}, {m_state.velocity.x, m_state.velocity.y}};
    }

private:
    phys_params m_params;
    ScenePointer m_scene;
    StepperPointer m_stepper;
    phys_state m_state{};
};

} // namespace

std::vector<EngineKind> ourEngines(const std::vector<Setting> &settings) {
    std::vector<EngineKind> engines;
    for (uint32_t index = 0; index < phys_registry_count(nullptr); ++index) {
        phys_stepper_info info;
        if (phys_registry_info(nullptr, index, &info) != PHYS_OK) continue;
        const bool hasRows = std::all_of(settings.begin(), settings.end(),
                                         [&](const Setting &setting) { return rowOf(setting.row, info) != nullptr; });
        if (!hasRows) continue;
        engines.push_back({info.id, true, (info.flags & PHYS_STEPPER_EXACT_IN_DT) != 0,
                           "model RIGID without friction (ROLLING where the ball rolls); defaults otherwise",
                           [info, settings](const Scene &scene, double) {
                               return std::make_unique<OurEngine>(info, scene, settings);
                           }});
    }
    return engines;
}

} // namespace bench
