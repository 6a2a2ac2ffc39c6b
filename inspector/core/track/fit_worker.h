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
    QString error; // one line without a fit
};

class FitWorker : public QObject {
    Q_OBJECT

public:
    explicit FitWorker(QObject *parent = nullptr)
        : QObject(parent) {}

    // From the thread that owns this object. Ends a fit that runs.
    void start(FitPlan plan);
    void cancel(); // no ended() follows
    bool isRunning() const { return m_isRunning; }

signals:
    void progressed(double share);
    void ended(const std::shared_ptr<const FitOutcome> &outcome);

private:
    bool m_isRunning = false;
    uint64_t m_run = 0;
    std::jthread m_thread; // last: ends before anything above it goes
};

} // namespace inspector
