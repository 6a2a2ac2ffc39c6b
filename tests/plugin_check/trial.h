// SPDX-License-Identifier: MIT
// Shared by the measurements: a board, and a ball on it under the stepper that is measured.
#pragma once

#include "measures.h"

#include "support/handles.h"
#include "witness/case.h"

#include <cstring>
#include <string>

namespace plugin_check {

std::string format(const char *text, double a, double b = 0, double c = 0);

/// No padding: phys_state says so.
inline bool isSame(const phys_state &a, const phys_state &b) {
    return std::memcmp(&a, &b, sizeof a) == 0; // NOLINT(bugprone-suspicious-memory-comparison)
}

constexpr double kRadius = 0.006; // of the ball on the board, m

/// A floor, a ball of 6 mm, gravity straight down.
witness::Case board(uint32_t model);

/// The ball rolls at this velocity.
void roll(witness::Case &scene, double x, double y);

/// A scene, a stepper, parameters and a state, made ready.
class Run {
public:
    Run(const Subject &subject, const witness::Case &scene);

    /// False once a step has failed.
    bool step(double dt, phys_report *report = nullptr);
    double energy() const;
    phys_status status() const { return m_status; }
    std::string why() const { return std::string(phys_status_name(m_status)) + ": " + m_error.text; }
    phys_stepper *stepper() const { return m_stepper.get(); }

    phys_params params{};
    phys_state state{};

private:
    support::ScenePtr m_scene;
    support::StepperPtr m_stepper;
    phys_status m_status = PHYS_OK;
    phys_error m_error{};
};

/// The rigid model, or the rolling one for a stepper that supports no other.
uint32_t modelOf(const Subject &subject);

} // namespace plugin_check
