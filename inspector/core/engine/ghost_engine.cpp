// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/ghost_engine.h"

#include "base/elementary.h"

#include <cmath>

namespace inspector {

namespace {

double lengthOf(const phys_vec3 &v) { return phys::elementary::hypot(phys::elementary::hypot(v.x, v.y), v.z); }

} // namespace

Deviation deviationOf(const Engine &ball, const Engine &other) {
    const phys_state &a = ball.state();
    const phys_state &b = other.state();
    const phys_vec3 apart{a.position.x - b.position.x, a.position.y - b.position.y, a.position.z - b.position.z};
    return {lengthOf(apart), lengthOf(a.velocity) - lengthOf(b.velocity),
            ball.report().energy_after - other.report().energy_after};
}

std::optional<GhostSetup> makeGhostSetup(const Registry &registry, const GhostChoice &ghostChoice, const Scene &scene,
                                         QString *error) {
    GhostSetup setup{scene, {}, {}, ghostChoice.substeps};
    phys_error failure;
    if (phys_registry_find(registry.get(), ghostChoice.stepper.constData(), &setup.info, &failure) != PHYS_OK) {
        tell(error, failure);
        return std::nullopt;
    }
    setup.stepper = makeStepper(registry, ghostChoice.stepper, scene, error);
    if (!setup.stepper) return std::nullopt;
    return setup;
}

GhostEngine::GhostEngine(const Engine &leader, const GhostSetup &setup, const QByteArray &leaderId)
    : m_engine(leader.scene(), setup.stepper)
    , m_setup(setup) {
    setLeaderStepper(leaderId);
    meet(leader);
}

void GhostEngine::meet(const Engine &leader) {
    phys_state state = leader.state();
    state.step *= uint64_t(m_setup.substeps); // so that its time is still computed from the step count: model.md 10.6
    m_engine.setState(state);
    m_previous = leader.previous();
    m_met = leader.state();
    m_deviation = {};
    m_isThere = true;
}

/// If the magnitudes of gravity are equal, the direction is the leader's to the last bit.
Inputs GhostEngine::inputsBeside(const Engine &leader) const {
    const std::optional<Inputs> &own = m_setup.own;
    Inputs inputs = own ? *own : leader.inputs();
    if (own && own->gravity != leader.inputs().gravity) {
        tiltBoard(inputs, leader.inputs().tilt);
    } else {
        inputs.tilt = leader.inputs().tilt;
        inputs.params.gravity = leader.inputs().params.gravity;
    }
    if (!own && !m_sharesValues) phys_stepper_info_init_params(&m_setup.info, &inputs.params);
    return inputs;
}

bool GhostEngine::follow(const Engine &leader, QString *error) {
    if (!m_isThere) return true;
    m_engine.setInputs(inputsBeside(leader));
    m_engine.setDt(leader.dt() / m_setup.substeps);
    m_previous = m_engine.state();
    if (m_previous.flags & PHYS_OUT) return true; // it stays at the exit
    for (int i = 0; i < m_setup.substeps && m_isThere; ++i) m_isThere = m_engine.step(error);
    if (!m_isThere) return false;
    m_deviation = deviationOf(leader, m_engine);
    return true;
}

void GhostEngine::addTo(Sample &sample) const {
    if (!m_isThere || (m_previous.flags & PHYS_OUT)) return;
    const phys_vec3 &position = m_engine.state().position;
    sample[Channel::GhostX] = position.x;
    sample[Channel::GhostY] = position.y;
    sample[Channel::GhostZ] = position.z;
    const phys_vec3 &velocity = m_engine.state().velocity;
    sample[Channel::GhostSpeed] = lengthOf(velocity);
    sample[Channel::GhostEnergy] = m_engine.report().energy_after;
    sample[Channel::Distance] = m_deviation.distance;
    sample[Channel::SpeedDifference] = m_deviation.speed;
    sample[Channel::EnergyDifference] = m_deviation.energy;
}

} // namespace inspector
