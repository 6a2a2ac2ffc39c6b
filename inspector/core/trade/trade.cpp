// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade.h"

#include "core/events/bounce.h"
#include "core/trade/good_enough.h"
#include "core/trade/quantile.h"
#include "core/trade/trade_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace inspector {

namespace {

constexpr int kBandBalls = 200; ///< per band of a chart

TradeCost costOf(std::vector<double> seconds, uint64_t steps, double duration) {
    std::sort(seconds.begin(), seconds.end());
    const double median = quantile(seconds, 0.5);
    const double spread = median > 0.0 ? (quantile(seconds, 0.75) - quantile(seconds, 0.25)) / median : 0.0;
    return {median / double(steps), median / duration, spread, int(seconds.size())};
}

/// The largest distance between the two models, both exact, radii.
double modelError(const TradeReference &rolling, const TradeReference &rigid, double until, double radius) {
    double largest = 0.0;
    const size_t count = std::min(rolling.states().size(), rigid.states().size());
    for (size_t i = 1; i < count && rolling.legs()[i - 1].end <= until; ++i)
        largest = std::max(largest, distance(rolling.states()[i].position, rigid.states()[i].position));
    return largest / radius;
}

std::optional<double> earlier(const std::optional<double> &a, const std::optional<double> &b) {
    if (!a || !b) return a ? a : b;
    return std::min(*a, *b);
}

/// Sorts by time and keeps the running maxima.
void keepRecords(std::vector<ErrorRecord> &growth) {
    std::stable_sort(growth.begin(), growth.end(),
                     [](const ErrorRecord &a, const ErrorRecord &b) { return a.time < b.time; });
    double largest = 0.0;
    std::erase_if(growth, [&](const ErrorRecord &record) {
        if (!(record.error > largest)) return true;
        largest = record.error;
        return false;
    });
}

/// The length of the longest common subsequence.
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

/// One schedule and its references.
struct Course {
    std::vector<TiltSegment> segments;
    std::optional<TradeReference> references[2]; ///< by model
};

/// The state of one measurement.
class Measurement {
public:
    Measurement(const TradePlan &plan, const TradeListener &listener, const std::stop_token &stop);

    bool makeReferences(QString *error);
    void listPoints();
    void run();
    TradeResult takeResult() { return std::move(m_result); }

private:
    using Motions = std::vector<ReferenceMotion>; ///< by schedule

    bool makeReference(size_t schedule, uint32_t model, QString *error);
    TradeSpan spanOf(const TradeReference &reference, uint32_t model) const;
    std::vector<size_t> order() const;
    Motions motionsOf(const TradePoint &point) const;
    void compareAll();
    void compare(TradePoint &point, const Motions &motions);
    std::optional<double> modelErrorOf(size_t schedule, uint32_t model) const;
    void timeAll();
    void time(size_t index);
    std::optional<double> timed(const TradePoint &point) const;
    void chooseGoodEnough();
    void tell(size_t index, const char *what);

    const TradePlan &m_plan;
    const TradeListener &m_listener;
    const std::stop_token &m_stop;
    std::vector<Course> m_courses;
    QString m_refusals[2];   ///< why a model lacks a reference; empty if it has all
    double m_duration = 0.0; ///< s, total of all schedules
    TradeResult m_result;
    std::vector<std::vector<double>> m_seconds; ///< by point, s of CPU time
    double m_done = 0.0;                        ///< steps done, for the progress
    double m_all = 0.0;
};

Measurement::Measurement(const TradePlan &plan, const TradeListener &listener, const std::stop_token &stop)
    : m_plan(plan)
    , m_listener(listener)
    , m_stop(stop) {
    for (const TiltSchedule &schedule : plan.schedules) {
        m_courses.push_back({segmentsOf(schedule, plan.inputs.gravity), {}});
        m_duration += schedule.duration;
    }
}

bool Measurement::makeReferences(QString *error) {
    const bool hasNone =
        std::any_of(m_courses.begin(), m_courses.end(), [](const Course &course) { return course.segments.empty(); });
    if (m_courses.empty() || hasNone) {
        *error = QStringLiteral("the schedule is empty");
        return false;
    }
    m_result.spans.resize(m_courses.size());
    for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID})
        for (size_t i = 0; i < m_courses.size(); ++i)
            if (!makeReference(i, model, &m_refusals[model])) break;
    if (m_refusals[0].isEmpty() || m_refusals[1].isEmpty()) return true;
    *error = QStringLiteral("stepper 'exact', to compare with: ") + m_refusals[m_plan.inputs.params.model];
    return false;
}

bool Measurement::makeReference(size_t schedule, uint32_t model, QString *error) {
    if (m_listener.progressed)
        m_listener.progressed(0.0, QStringLiteral("exact motion on %1").arg(m_plan.schedules[schedule].name));
    Course &course = m_courses[schedule];
    course.references[model] =
        TradeReference::run(m_plan.registry, m_plan.scene, paramsFor(m_plan, model), course.segments, error);
    if (!course.references[model]) return false;
    m_result.spans[schedule][model] = spanOf(*course.references[model], model);
    return true;
}

TradeSpan Measurement::spanOf(const TradeReference &reference, uint32_t model) const {
    TradeSpan span;
    span.end = reference.end();
    span.compared = reference.horizon(m_stop);
    span.isSensitive = span.compared < span.end;
    span.endReason = reference.endReason();
    span.impacts = countedImpacts(reference.impacts(), span.end);
    span.early = countedImpacts(reference.impacts(), m_plan.horizon);
    span.knowable = reference.roundingHorizon(m_stop);
    if (model != m_plan.inputs.params.model) return span;
    const BandPlan band{m_plan.registry, m_plan.scene, m_plan.inputs, m_plan.unknowns, kBandBalls, span.end};
    span.band = uncertaintyBand(band, reference, m_stop);
    return span;
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
                if (!m_refusals[model].isEmpty()) point.note = QStringLiteral("no reference: ") + m_refusals[model];
                m_result.points.push_back(point);
            }
        }
    }
    m_seconds.resize(m_result.points.size());
    for (const TradePoint &point : m_result.points)
        if (point.note.isEmpty()) m_all += (2.0 + m_plan.repeats) * std::ceil(m_duration / point.dt);
    if (m_listener.began) m_listener.began(m_result);
}

void Measurement::run() {
    compareAll();
    for (int repeat = 0; repeat < m_plan.repeats; ++repeat) timeAll();
    if (!m_plan.unknowns.empty()) chooseGoodEnough();
    m_result.isComplete = !m_stop.stop_requested();
}

/// Groups points of one model and step size: they share the reference states.
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

Measurement::Motions Measurement::motionsOf(const TradePoint &point) const {
    Motions motions;
    for (size_t i = 0; i < m_courses.size(); ++i)
        motions.push_back(
            motionOf(*m_courses[i].references[point.model], point.dt, m_result.spans[i][point.model].compared));
    return motions;
}

void Measurement::compareAll() {
    const TradePoint *previous = nullptr;
    Motions motions;
    for (const size_t index : order()) {
        TradePoint &point = m_result.points[index];
        if (m_stop.stop_requested()) return;
        if (!m_refusals[point.model].isEmpty()) continue;
        tell(index, "error of");
        if (!previous || previous->dt != point.dt || previous->model != point.model) motions = motionsOf(point);
        previous = &point;
        compare(point, motions);
        time(index);
    }
}

void Measurement::compare(TradePoint &point, const Motions &motions) {
    for (size_t i = 0; i < motions.size(); ++i) {
        QString note;
        point.errors.push_back(compareRun(runOf(m_plan, point), motions[i], m_stop, &note));
        point.errors.back().model = modelErrorOf(i, point.model);
        if (point.note.isEmpty()) point.note = note;
        for (const Leg &leg : motions[i].legs) point.steps += leg.steps;
    }
    point.error = worstOf(point.errors);
    point.isValid = point.note.isEmpty() && !m_stop.stop_requested();
    if (!m_result.spans[0][point.model].band.isEmpty()) point.share = shareOnSchedules(m_plan, m_result, point);
    m_done += 2.0 * double(point.steps);
}

std::optional<double> Measurement::modelErrorOf(size_t schedule, uint32_t model) const {
    if (!m_refusals[0].isEmpty() || !m_refusals[1].isEmpty()) return std::nullopt;
    if (model == PHYS_MODEL_RIGID) return 0.0;
    const auto &spans = m_result.spans[schedule];
    const auto &references = m_courses[schedule].references;
    return modelError(*references[0], *references[1], std::min(spans[0].compared, spans[1].compared),
                      phys_scene_radius(m_plan.scene.get()));
}

/// Measures all points in turn, several times, so that a busy moment of the machine doesn't affect all repeats of one
/// point.
void Measurement::timeAll() {
    for (size_t i = 0; i < m_result.points.size() && !m_stop.stop_requested(); ++i)
        if (m_result.points[i].isValid && int(m_seconds[i].size()) < m_plan.repeats) time(i);
}

void Measurement::time(size_t index) {
    TradePoint &point = m_result.points[index];
    tell(index, "cost of");
    if (point.isValid) {
        const std::optional<double> seconds = timed(point);
        if (m_stop.stop_requested()) return;
        point.isValid = seconds.has_value();
        if (!seconds) point.note = QStringLiteral("a step fails after the compared time");
        if (seconds) m_seconds[index].push_back(*seconds);
        if (seconds) point.cost = costOf(m_seconds[index], point.steps, m_duration);
    }
    m_done += double(point.steps);
    if (m_listener.measured) m_listener.measured(index, point);
}

/// Total CPU time over all schedules, s.
std::optional<double> Measurement::timed(const TradePoint &point) const {
    double all = 0.0;
    for (const Course &course : m_courses) {
        const std::optional<double> seconds =
            timeRun(runOf(m_plan, point), course.segments, legsOf(course.segments, point.dt), m_stop);
        if (!seconds) return std::nullopt;
        all += *seconds;
    }
    return all;
}

void Measurement::chooseGoodEnough() {
    if (m_stop.stop_requested() || !m_refusals[m_plan.inputs.params.model].isEmpty()) return;
    if (m_listener.progressed) m_listener.progressed(1.0, QStringLiteral("rehearsing"));
    ValidationSchedules validations(m_plan, m_stop);
    m_result.goodEnough = cheapestGoodEnough(m_plan, m_result, validations);
}

void Measurement::tell(size_t index, const char *what) {
    if (!m_listener.progressed) return;
    const TradePoint &point = m_result.points[index];
    m_listener.progressed(std::min(1.0, m_done / m_all),
                          QStringLiteral("%1 %2 at %3 ms")
                              .arg(QLatin1String(what), stepperName(m_plan.registry, point.stepper))
                              .arg(point.dt * 1e3, 0, 'g', 4));
}

} // namespace

double TradeResult::compared(uint32_t model) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto &span : spans) least = std::min(least, span[model].compared);
    return spans.empty() ? 0.0 : least;
}

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

TradeError worstOf(const std::vector<TradeError> &errors) {
    TradeError worst = errors.front();
    for (size_t i = 1; i < errors.size(); ++i) {
        const TradeError &error = errors[i];
        worst.positionLargest = std::max(worst.positionLargest, error.positionLargest);
        worst.positionFinal = std::max(worst.positionFinal, error.positionFinal);
        worst.velocityLargest = std::max(worst.velocityLargest, error.velocityLargest);
        worst.orientationLargest = std::max(worst.orientationLargest, error.orientationLargest);
        if (std::abs(error.energyDrift) > std::abs(worst.energyDrift)) worst.energyDrift = error.energyDrift;
        worst.penetrationLargest = std::max(worst.penetrationLargest, error.penetrationLargest);
        worst.timeUntilWrong = earlier(worst.timeUntilWrong, error.timeUntilWrong);
        worst.wrongImpacts = std::max(worst.wrongImpacts, error.wrongImpacts);
        if (worst.model && error.model) worst.model = std::max(*worst.model, *error.model);
        worst.growth.insert(worst.growth.end(), error.growth.begin(), error.growth.end());
    }
    keepRecords(worst.growth);
    return worst;
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
