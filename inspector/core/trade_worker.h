// SPDX-License-Identifier: GPL-3.0-or-later
// A measurement of the trade on a thread of its own.
#pragma once

#include "trade.h"

#include <QObject>

#include <thread>

namespace inspector {

class TradeWorker : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    // From the thread that owns this object. Ends a measurement that runs. plan: its schedule is made from the words
    // (trade_options.h), for at most so long.
    void start(TradePlan plan, const QString &schedule, double duration);
    void cancel(); // returns at once; ended() follows
    bool isRunning() const { return m_isRunning; }

    // As far as it is known; the owner's thread only.
    const TradeResult &result() const { return m_result; }
    const TradePlan &plan() const { return m_plan; } // with its schedule once there is a result

signals:
    void changed(); // result() has new figures
    void progressed(double share, const QString &what);
    void ended(const QString &error); // empty if it came to its end or was cancelled

private:
    void measure(TradePlan plan, const QString &schedule, double duration, const std::stop_token &stop);
    // In the owner's thread, unless another measurement was started meanwhile.
    template<typename Action>
    void post(Action action);

    TradePlan m_plan;
    TradeResult m_result;
    bool m_isRunning = false;
    uint64_t m_run = 0;    // the owner's
    std::jthread m_thread; // last: ends before anything above it goes
};

} // namespace inspector
