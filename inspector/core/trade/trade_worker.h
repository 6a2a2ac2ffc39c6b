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

    // From the thread that owns this object. Ends a measurement that runs. plan: its schedules are made from the words
    // (trade_options.h), for at most so long.
    void start(TradePlan plan, const QString &schedule, double duration);
    void cancel(); // returns at once; ended() follows
    bool isRunning() const { return m_isRunning; }

    // As far as it is known; the owner's thread only.
    const TradeResult &result() const { return m_result; }
    const TradePlan &plan() const { return m_plan; } // with its schedules once there is a result

signals:
    void changed(); // result() has new figures
    void progressed(double share, const QString &what);
    void ended(const QString &error); // empty if it came to its end or was cancelled

    void posted(QPrivateSignal); // there is news to take

private:
    struct News {
        uint64_t run; // that it is of
        std::function<void()> act;
    };

    void measure(TradePlan plan, const QString &schedule, double duration, const std::stop_token &stop);
    // Acts in the owner's thread, unless another measurement was started meanwhile.
    void post(std::function<void()> act);
    void takeNews();

    TradePlan m_plan;
    TradeResult m_result;
    bool m_isRunning = false;
    uint64_t m_run = 0; // changes only while no thread runs
    std::mutex m_lock;
    std::vector<News> m_news; // guarded by m_lock
    std::jthread m_thread;    // last: ends before anything above it goes
};

} // namespace inspector
