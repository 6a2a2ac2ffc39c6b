// SPDX-License-Identifier: GPL-3.0-or-later
// A simulation that its caller steps: stepper, state, inputs and dt. It has no thread and no clock, so every run gives
// the same bits. Two engines on one scene are two balls; Simulation runs one on a thread.
#pragma once

#include "core/engine/sample.h"
#include "core/pilot/pilot.h"
#include "core/setup/handles.h"
#include "core/setup/inputs.h"

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace inspector {

/// Energy lost since the state was last set, J/kg; `scheme` is gained, not lost.
struct EnergySums {
    double impact = 0.0, rolling = 0.0, slip = 0.0, scheme = 0.0;
};

class Engine {
public:
    static constexpr double kDefaultDt = 0.01;  ///< s
    static constexpr double kSmallestDt = 1e-6; ///< s, what the user may choose
    static constexpr double kLargestDt = 10.0;  ///< s
    static constexpr uint32_t kEventCapacity = 64;

    /// At the scene's start, with the library's defaults.
    Engine(Scene scene, Stepper stepper);

    const Scene &scene() const { return m_scene; }
    /// Restarts in another scene, without a pilot.
    void setScene(Scene scene, Stepper stepper);
    /// Continues from the same state; the stepper must have been made for the same scene.
    void setStepper(Stepper stepper) { m_stepper = std::move(stepper); }

    void setInputs(const Inputs &inputs);
    const Inputs &inputs() const { return m_inputs; }  ///< inputs of the last step, including the pilot's tilt
    void setPilot(std::shared_ptr<const Pilot> pilot); ///< nullptr: the tilt of the inputs is used
    void setDt(double dt) { m_dt = dt; }               ///< s, >= 0
    double dt() const { return m_dt; }

    /// Goes to the scene's start, or to the one set by setStart().
    void restart();
    void setStart(const std::optional<phys_state> &start) { m_start = start; } ///< empty: the scene's
    /// sums: zero, or the energy that the run had lost up to there.
    void setState(const phys_state &state, const EnergySums &sums = {});
    const phys_state &state() const { return m_state; }
    const phys_state &previous() const { return m_previous; }
    const EnergySums &sums() const { return m_sums; }
    const EnergySums &previousSums() const { return m_previousSums; }

    /// Makes one step of dt. If it fails, the state is unchanged and `error` gets the library's line.
    bool step(QString *error);

    const phys_report &report() const { return m_report; } ///< of the last step; all zero before the first
    std::span<const phys_event> events() const { return {m_events.data(), m_report.event_count}; }
    Sample sample() const;

private:
    void askPilot();

    Scene m_scene;
    Stepper m_stepper;
    std::shared_ptr<const Pilot> m_pilot;
    bool m_pilotIsNew = false; ///< it hasn't been called yet
    Inputs m_given = initialInputs();
    Inputs m_inputs = m_given;
    double m_dt = kDefaultDt;
    std::optional<phys_state> m_start; ///< set by setStart()
    phys_state m_state{};
    phys_state m_previous{};
    std::array<phys_event, kEventCapacity> m_events{};
    phys_report m_report{};
    EnergySums m_sums;
    EnergySums m_previousSums;
};

} // namespace inspector
