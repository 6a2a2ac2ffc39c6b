// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade.h"

#include "core/events/counted_impact.h"
#include "core/trade/trade_reference.h"
#include "core/trade/trade_run.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace inspector {

namespace {

double quantile(const std::vector<double> &sorted, double share) {
    const double place = share * double(sorted.size() - 1);
    const auto below = size_t(place);
    const size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - double(below)) * (sorted[above] - sorted[below]);
}

TradeCost costOf(std::vector<double> seconds, uint64_t steps, double duration) {
    std::sort(seconds.begin(), seconds.end());
    const double median = quantile(seconds, 0.5);
    const double spread = median > 0.0 ? (quantile(seconds, 0.75) - quantile(seconds, 0.25)) / median : 0.0;
    return {median / double(steps), median / duration, spread, int(seconds.size())};
}

// The largest distance between the two models, both exact, in radii.
double modelError(const TradeReference &rolling, const TradeReference &rigid, double until, double radius) {
    double largest = 0.0;
    const size_t count = std::min(rolling.states().size(), rigid.states().size());
    for (size_t i = 1; i < count && rolling.legs()[i - 1].end <= until; ++i)
        largest = std::max(largest, distance(rolling.states()[i].position, rigid.states()[i].position));
    return largest / radius;
}

// The length of the longest sequence of boxes that both have in their order.
int commonLength(const std::vector<uint32_t> &a, const std::vector<uint32_t> &b) {
    std::vector<int> row(b.size() + 1, 0);
    for (const uint32_t box : a) {
        int diagonal = 0;
        for (size_t j = 0; j < b.size(); ++j) {
            const int above = row[j + 1];
            row[j + 1] = box == b[j] ? diagonal + 1 : std::max(above, row[j]);
            diagonal = above;
        }
    }
    return row.back();
}

std::vector<uint32_t> boxesHit(const std::vector<Impact> &impacts, double speed) {
    std::vector<uint32_t> boxes;
    for (const Impact &impact : impacts)
        if (impact.speed >= speed) boxes.push_back(impact.box);
    return boxes;
}

// What one measurement holds while it runs.
class Measurement {
public:
    Measurement(const TradePlan &plan, const TradeListener &listener, const std::stop_token &stop)
        : m_plan(plan)
        , m_listener(listener)
        , m_stop(stop)
        , m_segments(segmentsOf(plan.schedule, plan.inputs.gravity)) {}

    bool makeReferences(QString *error);
    void listPoints();
    void run();
    TradeResult takeResult() { return std::move(m_result); }

private:
    phys_params paramsOf(const TradePoint &point) const;
    std::vector<size_t> order() const;
    void compareAll();
    void compare(TradePoint &point, const std::vector<Leg> &legs, const std::vector<phys_state> &states);
    void timeAll();
    void time(size_t index);
    void tell(size_t index, const char *what);

    const TradePlan &m_plan;
    const TradeListener &m_listener;
    const std::stop_token &m_stop;
    std::vector<Segment> m_segments;
    std::optional<TradeReference> m_references[2]; // by model
    QString m_refusals[2];
    TradeResult m_result;
    std::vector<std::vector<double>> m_seconds; // of each point, s of CPU time
    double m_done = 0.0;                        // steps, counted for the progress
    double m_all = 0.0;
};

bool Measurement::makeReferences(QString *error) {
    if (m_segments.empty()) {
        *error = QStringLiteral("the schedule is empty");
        return false;
    }
    for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
        phys_params params = m_plan.inputs.params;
        params.model = model;
        m_references[model] =
            TradeReference::run(m_plan.registry, m_plan.scene, params, m_segments, &m_refusals[model]);
        if (!m_references[model]) continue;
        const double horizon = m_references[model]->horizon(m_stop);
        const double end = m_references[model]->end();
        m_result.spans[model] = {horizon, horizon < end, m_references[model]->endReason()};
    }
    if (m_references[0] || m_references[1]) return true;
    *error = QStringLiteral("stepper 'exact', to compare with: ") + m_refusals[m_plan.inputs.params.model];
    return false;
}

void Measurement::listPoints() {
    std::vector<double> sizes = m_plan.stepSizes;
    std::sort(sizes.rbegin(), sizes.rend());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
        for (uint32_t i = 0; i < phys_registry_count(m_plan.registry.get()); ++i) {
            phys_stepper_info info;
            phys_registry_info(m_plan.registry.get(), i, &info);
            for (const double dt : sizes) {
                TradePoint point;
                point.stepper = info.id;
                point.dt = dt;
                point.model = model;
                if (!m_references[model]) point.note = QStringLiteral("no reference: ") + m_refusals[model];
                m_result.points.push_back(point);
            }
        }
    }
    m_seconds.resize(m_result.points.size());
    for (const TradePoint &point : m_result.points)
        if (point.note.isEmpty()) m_all += (2.0 + m_plan.repeats) * std::ceil(m_plan.schedule.duration / point.dt);
    if (m_listener.began) m_listener.began(m_result);
}

void Measurement::run() {
    compareAll();
    for (int repeat = 0; repeat < m_plan.repeats; ++repeat) timeAll();
    m_result.isComplete = !m_stop.stop_requested();
}

phys_params Measurement::paramsOf(const TradePoint &point) const {
    phys_params params = m_plan.inputs.params;
    phys_stepper_info info;
    if (phys_registry_find(m_plan.registry.get(), point.stepper.constData(), &info, nullptr) == PHYS_OK)
        phys_stepper_info_init_params(&info, &params);
    params.model = point.model;
    return params;
}

// Points of one model and step size in a row: they share the states to compare with.
std::vector<size_t> Measurement::order() const {
    std::vector<size_t> indices(m_result.points.size());
    std::iota(indices.begin(), indices.end(), size_t(0));
    std::stable_sort(indices.begin(), indices.end(), [&](size_t a, size_t b) {
        const TradePoint &left = m_result.points[a];
        const TradePoint &right = m_result.points[b];
        return left.model != right.model ? left.model < right.model : left.dt > right.dt;
    });
    return indices;
}

void Measurement::compareAll() {
    const TradePoint *previous = nullptr;
    std::vector<Leg> legs;
    std::vector<phys_state> states;
    for (const size_t index : order()) {
        TradePoint &point = m_result.points[index];
        if (m_stop.stop_requested()) return;
        if (!m_references[point.model]) continue;
        tell(index, "error of");
        if (!previous || previous->dt != point.dt || previous->model != point.model) {
            legs = legsOf(m_segments, point.dt);
            states = m_references[point.model]->statesAt(legs);
        }
        previous = &point;
        compare(point, legs, states);
        time(index);
    }
}

void Measurement::compare(TradePoint &point, const std::vector<Leg> &legs, const std::vector<phys_state> &states) {
    const TradeReference &reference = *m_references[point.model];
    const double until = m_result.spans[point.model].compared;
    const ReferenceMotion motion{m_segments, legs, states, reference.impacts(), until};
    TradeRun run{m_plan.registry, m_plan.scene, point.stepper, paramsOf(point)};
    point.error = compareRun(run, motion, m_stop, &point.note);
    point.isValid = point.note.isEmpty() && !m_stop.stop_requested();
    for (const Leg &leg : legs) point.steps += leg.steps;
    m_done += 2.0 * double(point.steps);
    if (!m_references[0] || !m_references[1]) return;
    const double both = std::min(m_result.spans[0].compared, m_result.spans[1].compared);
    point.error.model = point.model == PHYS_MODEL_RIGID ? 0.0
                                                        : modelError(*m_references[0], *m_references[1], both,
                                                                     phys_scene_radius(m_plan.scene.get()));
}

// One after the other and then all again: a busy moment of the machine doesn't hit all repeats of one point.
void Measurement::timeAll() {
    for (size_t i = 0; i < m_result.points.size() && !m_stop.stop_requested(); ++i)
        if (m_result.points[i].isValid && int(m_seconds[i].size()) < m_plan.repeats) time(i);
}

void Measurement::time(size_t index) {
    TradePoint &point = m_result.points[index];
    tell(index, "cost of");
    if (point.isValid) {
        const TradeRun run{m_plan.registry, m_plan.scene, point.stepper, paramsOf(point)};
        const std::optional<double> seconds = timeRun(run, m_segments, legsOf(m_segments, point.dt), m_stop);
        if (m_stop.stop_requested()) return;
        point.isValid = seconds.has_value();
        if (!seconds) point.note = QStringLiteral("a step fails after the compared time");
        if (seconds) m_seconds[index].push_back(*seconds);
        if (seconds) point.cost = costOf(m_seconds[index], point.steps, m_plan.schedule.duration);
    }
    m_done += double(point.steps);
    if (m_listener.measured) m_listener.measured(index, point);
}

void Measurement::tell(size_t index, const char *what) {
    if (!m_listener.progressed) return;
    const TradePoint &point = m_result.points[index];
    m_listener.progressed(std::min(1.0, m_done / m_all), QStringLiteral("%1 %2 at %3 ms")
                                                             .arg(QLatin1String(what), QString::fromUtf8(point.stepper))
                                                             .arg(point.dt * 1e3, 0, 'g', 4));
}

} // namespace

std::vector<TradePoint> TradeResult::valid(uint32_t model) const {
    std::vector<TradePoint> result;
    for (const TradePoint &point : points)
        if (point.isValid && point.model == model && point.cost.repeats > 0) result.push_back(point);
    return result;
}

int wrongImpacts(const std::vector<Impact> &expected, const std::vector<Impact> &found) {
    const auto unmatched = [](const std::vector<Impact> &fast, const std::vector<Impact> &all) {
        const std::vector<uint32_t> boxes = boxesHit(fast, kCountedImpact);
        return int(boxes.size()) - commonLength(boxes, boxesHit(all, 0.5 * kCountedImpact));
    };
    return unmatched(expected, found) + unmatched(found, expected);
}

std::optional<TradeResult> measureTrade(const TradePlan &plan, const TradeListener &listener,
                                        const std::stop_token &stop, QString *error) {
    Measurement measurement(plan, listener, stop);
    if (!measurement.makeReferences(error)) return std::nullopt;
    measurement.listPoints();
    measurement.run();
    if (listener.progressed && !stop.stop_requested()) listener.progressed(1.0, QString());
    return measurement.takeResult();
}

} // namespace inspector
