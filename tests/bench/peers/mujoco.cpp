// SPDX-License-Identifier: MIT
// MuJoCo: three dimensions, on a floor. It has no restitution: contacts are springs, tuned here so that they bounce.
#include "peers/engine.h"

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace bench {

namespace {

// Ratio of the speeds after and before a head-on impact on a spring with damping (per mass), as the engine steps it;
// the wall is detected `phase` of a step late.
double restitutionOf(double stiffness, double damping, double dt, double phase) {
    double velocity = -1;
    double depth = -phase * dt; // negative: inside
    constexpr int kSteps = 200;
    for (int step = 0; step < kSteps && depth < 0; ++step) {
        velocity += dt * std::max(0.0, -damping * velocity - stiffness * depth);
        depth += dt * velocity;
    }
    return velocity;
}

double meanRestitution(double stiffness, double damping, double dt) {
    constexpr int kPhases = 32;
    double sum = 0;
    for (int phase = 0; phase < kPhases; ++phase) sum += restitutionOf(stiffness, damping, dt, (phase + 0.5) / kPhases);
    return sum / kPhases;
}

// The damping whose impact has this restitution. Restitution falls with damping, so bisection finds it.
double dampingFor(double restitution, double stiffness, double dt) {
    double low = 0;
    double high = 4 * std::sqrt(stiffness);
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (meanRestitution(stiffness, middle, dt) > restitution ? low : high) = middle;
    }
    return low;
}

std::string modelText(const Scene &scene, double dt) {
    const double stiffness = std::pow(0.5 / dt, 2);
    const double damping = dampingFor(scene.restitution, stiffness, dt);
    const double critical = 2 * std::sqrt(stiffness);
    const char *impedance = "solimp='0.9999 0.9999 0.001'";
    std::ostringstream text;
    text.precision(17);
    text << "<mujoco><size nconmax='100' njmax='500'/><option timestep='" << dt << "' cone='elliptic'/><worldbody>"
         << "<geom type='plane' size='0 0 1' priority='1' condim='" << (scene.rolls ? 3 : 1)
         << "' friction='1 0 0' solref='" << -stiffness << " " << -critical << "' " << impedance << "/>";
    for (const Wall &wall : scene.walls)
        text << "<geom type='box' priority='1' condim='1' solref='" << -stiffness << " " << -damping << "' "
             << impedance << " pos='" << (wall.x0 + wall.x1) / 2 << " " << (wall.y0 + wall.y1) / 2 << " "
             << kWallHeight / 2 << "' size='" << (wall.x1 - wall.x0) / 2 << " " << (wall.y1 - wall.y0) / 2 << " "
             << kWallHeight / 2 << "'/>";
    text << "<body pos='0 0 " << scene.radius << "'><freejoint/><geom type='sphere' mass='1' condim='1' size='"
         << scene.radius << "'/></body></worldbody></mujoco>";
    return text.str();
}

mjModel *compile(const std::string &text) {
    const auto files = std::make_unique<mjVFS>(); // megabytes
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(text.size()));
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), "scene.xml")], text.data(), text.size());
    char problem[500] = "";
    mjModel *model = mj_loadXML("scene.xml", files.get(), problem, sizeof problem);
    mj_deleteFileVFS(files.get(), "scene.xml");
    if (!model) throw std::runtime_error(problem);
    return model;
}

class MujocoEngine final : public Engine {
public:
    MujocoEngine(const Scene &scene, double dt)
        : m_model(compile(modelText(scene, dt)))
        , m_data(mj_makeData(m_model))
        , m_radius(scene.radius) {
        place(scene.start);
    }
    MujocoEngine(const MujocoEngine &) = delete;
    MujocoEngine &operator=(const MujocoEngine &) = delete;
    ~MujocoEngine() override {
        mj_deleteData(m_data);
        mj_deleteModel(m_model);
    }

    void place(const Ball &ball) override {
        mj_resetData(m_model, m_data);
        const double position[] = {ball.position.x, ball.position.y, m_radius};
        const double velocity[] = {ball.velocity.x, ball.velocity.y, 0};
        std::copy_n(position, 3, m_data->qpos);
        std::copy_n(velocity, 3, m_data->qvel);
    }

    void setGravity(const phys_vec3 &gravity) override {
        const double components[] = {gravity.x, gravity.y, gravity.z};
        std::copy_n(components, 3, m_model->opt.gravity);
    }

    void advance(double dt, int steps) override {
        m_model->opt.timestep = dt;
        for (int step = 0; step < steps; ++step) mj_step(m_model, m_data);
    }

    Ball ball() const override { return {{m_data->qpos[0], m_data->qpos[1]}, {m_data->qvel[0], m_data->qvel[1]}}; }

private:
    mjModel *m_model;
    mjData *m_data;
    double m_radius;
};

} // namespace

std::vector<EngineKind> mujocoEngines() {
    return {{"mujoco", false, false,
             "3D, double; contacts as springs of stiffness (0.5/dt)^2 with the damping that gives the restitution; "
             "elliptic cone; solimp "
             "0.9999 0.9999 0.001; no continuous detection exists",
             [](const Scene &scene, double dt) { return std::make_unique<MujocoEngine>(scene, dt); }}};
}

} // namespace bench
