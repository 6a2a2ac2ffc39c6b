// SPDX-License-Identifier: MIT
// libphysics through its public C interface: an engine for each stepper.
#include "peers/engine.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace bench {

namespace {

void check(phys_status status, const phys_error &error) {
    if (status != PHYS_OK) throw std::runtime_error(error.text);
}

std::vector<phys_box> boxesOf(const Scene &scene) {
    const Wall floor = floorOf(scene);
    std::vector<phys_box> boxes{{{floor.x0, floor.y0, -kFloorThickness}, {floor.x1, floor.y1, 0}}};
    for (const Wall &wall : scene.walls) boxes.push_back({{wall.x0, wall.y0, 0}, {wall.x1, wall.y1, kWallHeight}});
    return boxes;
}

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
        : m_params(paramsOf(scene, info, settings)) {
        phys_error error;
        const std::vector<phys_box> boxes = boxesOf(scene);
        phys_scene_desc description;
        phys_scene_desc_init(&description, sizeof description);
        description.box_count = static_cast<uint32_t>(boxes.size());
        description.boxes = boxes.data();
        description.radius = scene.radius;
        description.start = {scene.start.position.x, scene.start.position.y, scene.radius};
        check(phys_scene_create(&description, &m_scene, &error), error);
        const phys_status made = phys_stepper_create(nullptr, info.id, m_scene, &m_stepper, &error);
        if (made != PHYS_OK) phys_scene_destroy(m_scene);
        check(made, error);
        phys_scene_start(m_scene, &m_state);
    }
    OurEngine(const OurEngine &) = delete;
    OurEngine &operator=(const OurEngine &) = delete;
    ~OurEngine() override {
        phys_stepper_destroy(m_stepper);
        phys_scene_destroy(m_scene);
    }

    void place(const Ball &ball) override {
        phys_scene_start(m_scene, &m_state);
        m_state.position.x = ball.position.x;
        m_state.position.y = ball.position.y;
        m_state.velocity = {ball.velocity.x, ball.velocity.y, 0};
    }

    void setGravity(const phys_vec3 &gravity) override { m_params.gravity = gravity; }

    void advance(double dt, int steps) override {
        for (int step = 0; step < steps; ++step) {
            phys_error error;
            check(phys_step(m_stepper, &m_params, dt, &m_state, &m_state, nullptr, &error), error);
        }
    }

    Ball ball() const override {
        return {{m_state.position.x, m_state.position.y}, {m_state.velocity.x, m_state.velocity.y}};
    }

private:
    phys_params m_params;
    phys_scene *m_scene = nullptr;
    phys_stepper *m_stepper = nullptr;
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
