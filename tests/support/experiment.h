// SPDX-License-Identifier: MIT
// One ball in one scene under one stepper.
#pragma once

#include "scene_builder.h"

#include <QByteArray>

#include <array>
#include <string>

namespace support {

/// Gravity's part into the floor, m/s^2: a power of two, so that figures that are exact in binary stay exact.
inline constexpr double kNormalGravity = 8.0;

/// Functions that return false give the reason in error(); use them as QVERIFY2(e.stepFor(..), e.error()).
class Experiment {
public:
    /// Parameters start as phys_params_init fills them, with gravity (0, 0, -kNormalGravity), no friction, model.
    Experiment(const SceneBuilder &scene, const QByteArray &stepper, uint32_t model = PHYS_MODEL_ROLLING);
    Experiment(ScenePtr scene, const QByteArray &stepper, uint32_t model = PHYS_MODEL_ROLLING);

    bool isReady() const { return m_stepper != nullptr; }
    const char *error() const { return m_error.text; }
    phys_status status() const { return m_error.status; }
    phys_scene *scene() const { return m_scene.get(); }
    phys_stepper *stepper() const { return m_stepper.get(); }

    /// The constants of model.md 3.1 for a rolling ball: sets gravity and rolling_friction. Exact for A and B of the
    /// form 5 * 2^-k.
    void setLaw(double ax, double ay, double B = 0.0);
    /// Velocity in the plane with the spin of rolling.
    void roll(double vx, double vy);
    void setPosition(double x, double y);

    bool step(double dt);
    bool stepTimes(uint64_t count, double dt);
    /// Steps until `duration` has passed; it should be a multiple of dt.
    bool stepFor(double duration, double dt);
    /// Replaces the stepper by a new one.
    bool renewStepper();

    phys_params params{};
    phys_state state{};
    phys_report report{}; ///< of the last step; its events are valid as long as this object exists and isn't moved

private:
    void prepare(uint32_t model);

    ScenePtr m_scene;
    StepperPtr m_stepper;
    QByteArray m_id;
    phys_error m_error{};
    std::array<phys_event, 1024> m_events{};
};

} // namespace support
