// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/fit_worker.h"

#include <QMetaObject>

namespace inspector {

void FitWorker::start(FitPlan plan) {
    m_thread = {}; // requests a stop and joins
    m_isRunning = true;
    // Queued calls are dropped with this object; those of an earlier run are recognised by its number.
    const auto post = [this, run = ++m_run](auto act) {
        QMetaObject::invokeMethod(
            this,
            [this, run, act] {
                if (run == m_run) act();
            },
            Qt::QueuedConnection);
    };
    m_thread = std::jthread([this, post, plan = std::move(plan)](const std::stop_token &stop) mutable {
        const auto outcome = std::make_shared<FitOutcome>();
        const FitProgress progress = [&](double share, const QString &) {
            post([this, share] { emit progressed(share); });
        };
        outcome->fit = fitTrack(plan, progress, stop, &outcome->error);
        outcome->plan = std::move(plan);
        post([this, outcome] {
            m_isRunning = false;
            emit ended(outcome);
        });
    });
}

void FitWorker::cancel() {
    ++m_run;
    m_isRunning = false;
    m_thread = {};
}

} // namespace inspector
