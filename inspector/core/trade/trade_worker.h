// SPDX-License-Identifier: GPL-3.0-or-later
// A measurement of the trade on a thread of its own.
#pragma once

#include "core/trade/trade.h"

#include <QObject>

#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace inspector {

class TradeWorker : public QObject {
    Q_OBJECT

public:
    explicit TradeWorker(QObject *parent = nullptr);

    /// Called by the owner's thread. Cancels a running measurement. plan: its schedules are made from the words
    /// (trade_options.h), each at most `duration` long, s.
    void start(TradePlan plan, const QString &schedule, double duration);
    void cancel(); ///< returns immediately; ended() follows
    bool isRunning() const { return m_isRunning; }

    /// The result so far; the owner's thread only.
    const TradeResult &result() const { return m_result; }
    const TradePlan &plan() const { return m_plan; } ///< has its schedules once there is a result

signals:
    void changed(); ///< result() has new figures
    void progressed(double share, const QString &what);
    void ended(const QString &error); ///< empty if it finished or was cancelled

    void posted(QPrivateSignal); ///< news was queued

private:
    struct News {
        uint64_t run; ///< that the news belongs to
        std::function<void()> act;
    };

    void measure(TradePlan plan, const QString &schedule, double duration, const std::stop_token &stop);
    /// Runs `act` in the owner's thread, unless another measurement has been started meanwhile.
    void post(std::function<void()> act);
    void takeNews();

    TradePlan m_plan;
    TradeResult m_result;
    bool m_isRunning = false;
    uint64_t m_run = 0; ///< changes only while no thread runs
    std::mutex m_lock;
    std::vector<News> m_news; ///< guarded by m_lock
    std::jthread m_thread;    ///< last member: it is joined before the others are destroyed
};

} // namespace inspector
