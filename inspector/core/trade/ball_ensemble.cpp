// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/ball_ensemble.h"

#include "core/schedule/trade_reference.h"
#include "core/setup/walls.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace inspector {

namespace {

bool isInWall(const phys_scene *scene, const phys_vec3 &centre) {
    const std::optional<phys_contact> wall = nearestWall(scene, centre, 0.0);
    return wall && wall->gap < 0.0;
}

} // namespace

BallEnsemble::BallEnsemble(Stepper stepper, const Scene &scene, const std::vector<SampledBoard> &boards,
                           const phys_state &start)
    : m_stepper(std::move(stepper))
    , m_statuses(boards.size()) {
    for (const SampledBoard &board : boards) {
        Ball ball{board, start};
        ball.state.position.x += board.startOffset.x;
        ball.state.position.y += board.startOffset.y;
        if (isInWall(scene.get(), ball.state.position)) ball.state.position = start.position;
        m_balls.push_back(ball);
    }
}

void BallEnsemble::setBoards(const std::vector<SampledBoard> &boards) {
    for (size_t i = 0; i < m_balls.size(); ++i) m_balls[i].board = boards[i];
}

void BallEnsemble::step(const Tilt &tilt, double dt, uint64_t steps) {
    for (Ball &ball : m_balls) {
        const Tilt &offset = ball.board.tiltOffset;
        ball.isRefused |= phys_gravity_from_tilt(tilt.x + offset.x, tilt.y + offset.y, ball.board.gravity,
                                                 &ball.board.params.gravity) != PHYS_OK;
    }
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.stop_flags = PHYS_OUT;
    batch.ball_count = m_balls.size();
    batch.step_count = steps;
    batch.dt = dt;
    batch.params = &m_balls.front().board.params;
    batch.params_stride = sizeof(Ball);
    batch.states = &m_balls.front().state;
    batch.states_stride = sizeof(Ball);
    batch.statuses = m_statuses.data();
    const bool hasRun = phys_batch_run(m_stepper.get(), &batch, 0, m_balls.size(), nullptr) == PHYS_OK;
    for (size_t i = 0; i < m_balls.size(); ++i) m_balls[i].isRefused |= !hasRun || m_statuses[i] != PHYS_OK;
}

std::vector<double> BallEnsemble::distancesFrom(const phys_vec3 &centre) const {
    std::vector<double> distances;
    distances.reserve(m_balls.size());
    for (const Ball &ball : m_balls)
        distances.push_back(ball.isRefused ? std::numeric_limits<double>::quiet_NaN()
                                           : distance(ball.state.position, centre));
    return distances;
}

int BallEnsemble::refused() const {
    return int(std::count_if(m_balls.begin(), m_balls.end(), [](const Ball &ball) { return ball.isRefused; }));
}

} // namespace inspector
