// SPDX-License-Identifier: GPL-3.0-or-later
// A fit on a thread of its own.
#pragma once

#include "core/track/track_fit.h"

#include <QObject>

#include <memory>
#include <thread>

namespace inspector {

struct FitOutcome {
    FitPlan plan;
    std::optional<TrackFit> fit;
    QString error; ///< one line if there is no fit
};

class FitWorker : public QObject {
    Q_OBJECT

public:
    explicit FitWorker(QObject *parent = nullptr)
        : QObject(parent) {}

    /// Called by the owner's thread. Cancels a running fit.
    void start(FitPlan plan);
    void cancel(); ///< ended() isn't sent
    bool isRunning() const { return m_isRunning; }

signals:
    void progressed(double share);
    void ended(const std::shared_ptr<const FitOutcome> &outcome);

private:
    bool m_isRunning = false;
    uint64_t m_run = 0;
    std::jthread m_thread; ///< last member: it is joined before the others are destroyed
};

} // namespace inspector
