// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_worker.h"

#include "core/trade/trade_options.h"

namespace inspector {

TradeWorker::TradeWorker(QObject *parent)
    : QObject(parent) {
    connect(this, &TradeWorker::posted, this, &TradeWorker::takeNews, Qt::QueuedConnection);
}

void TradeWorker::start(TradePlan plan, const QString &schedule, double duration) {
    m_thread = {}; // requests a stop and joins
    ++m_run;
    m_isRunning = true;
    m_result = {};
    m_plan = plan;
    emit changed();
    m_thread = std::jthread([this, plan = std::move(plan), schedule, duration](const std::stop_token &stop) mutable {
        measure(std::move(plan), schedule, duration, stop);
    });
}

void TradeWorker::cancel() { m_thread.request_stop(); }

void TradeWorker::post(std::function<void()> act) {
    {
        const std::lock_guard guard(m_lock);
        m_news.push_back({m_run, std::move(act)});
    }
    emit posted(QPrivateSignal());
}

void TradeWorker::takeNews() {
    std::vector<News> news;
    {
        const std::lock_guard guard(m_lock);
        news.swap(m_news);
    }
    for (const News &item : news) {
        if (item.run == m_run) item.act();
    }
}

void TradeWorker::measure(TradePlan plan, const QString &schedule, double duration, const std::stop_token &stop) {
    QString error;
    const bool isReady = makeSchedules(schedule, duration, plan, &error);
    TradeListener listener;
    listener.began = [&](const TradeResult &result) {
        post([this, plan, result] {
            m_plan = plan;
            m_result = result;
            emit changed();
        });
    };
    listener.measured = [this](size_t index, const TradePoint &point) {
        post([this, index, point] {
            m_result.points[index] = point;
            emit changed();
        });
    };
    listener.progressed = [this](double share, const QString &what) {
        post([this, share, what] { emit progressed(share, what); });
    };
    std::optional<TradeResult> result;
    if (isReady) result = measureTrade(plan, listener, stop, &error);
    post([this, isComplete = result && result->isComplete, goodEnough = result ? result->goodEnough : std::nullopt,
          line = result ? QString() : error] {
        m_isRunning = false;
        m_result.isComplete = isComplete;
        m_result.goodEnough = goodEnough;
        emit ended(line);
    });
}

} // namespace inspector
