// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/track_fit.h"

#include "core/events/bounce.h"
#include "core/setup/tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace inspector {

namespace {

constexpr double kLeastNoise = 1e-7;     ///< m: even a noiseless track has rounding
constexpr double kFirstLength = 0.3;     ///< s, initial length of a segment
constexpr double kFirstStride = 0.2;     ///< s, initial growth of a segment
constexpr double kShortestStride = 0.05; ///< s
constexpr double kStrideGrowth = 1.6;    ///< factor of the next stride after a success
constexpr double kLongestSegment = 2.0;  ///< s: a longer segment adds little information
constexpr size_t kFewestPoints = 12;     ///< in a new segment
constexpr int kSteps = 8;                ///< iterations of a fit
constexpr double kReach = 0.15;          ///< s, within which the next segment must begin
constexpr double kTrialLength = 4.0;     ///< s, that initial parameters must explain in a trial
constexpr std::array<double, 4> kTrialPlaces{0.0, 0.25, 0.5, 0.75}; ///< as shares of the track
constexpr int kMostAttempts = 2;                                    ///< at fitting the whole track
constexpr size_t kWindow = 40;                                      ///< residuals judged together
constexpr double kMostDeviations = 4.0;    ///< standard deviations by which a sample of noise may exceed its mean
constexpr double kNoiseUncertainty = 1.04; ///< the noise itself is known to a few percent
constexpr double kInflation = 10.0;        ///< factor on the deviations before all segments are fitted again
constexpr int kMostBreaks = 6;             ///< breaks after which a model is abandoned
constexpr double kMatched = 3.0;           ///< times the noise, around a matched bounce
constexpr double kNearMatch = 0.05;        ///< s
constexpr double kNearBreak = 0.1;         ///< s
/// Share of bounces at which a good model may diverge: a random residual may look like a break.
constexpr double kAllowedBreaks = 0.1;

double rmsOf(const std::vector<double> &residuals, size_t from, size_t to) {
    double squares = 0.0;
    for (size_t i = from; i < to; ++i) squares += residuals[i] * residuals[i];
    return std::sqrt(squares / double(std::max<size_t>(to - from, 1)));
}

/// Fits one model along the track, segment by segment. A segment is extended and refitted as long as its residuals are
/// noise; the estimate so far then predicts the next moments well enough to identify bounces. Where it can't be
/// extended, a new segment begins with the current estimate as its prior.
class SequentialFit {
public:
    SequentialFit(const FitPlan &plan, const BallModel &model, const BoardParameters &begin, double noise,
                  const std::stop_token &stop)
        : m_model(model)
        , m_track(model.track())
        , m_board(begin)
        , m_noise(noise)
        , m_stop(stop) {
        for (const FitQuantity &quantity : plan.quantities)
            (begin.params.model == PHYS_MODEL_RIGID || !quantity.isRigidOnly ? m_quantities : m_withoutEffect)
                .push_back(quantity);
        m_estimate = weakPrior(m_quantities, begin);
    }

    /// Fits points [first, end), until there are `mostBreaks` breaks.
    void run(size_t first, size_t end, int mostBreaks, const FitProgress &progress);
    void refine();
    bool hasBegun() const { return !m_segments.empty(); }
    int breaks() const { return int(m_diverged.size()); }
    size_t next() const { return m_next; }
    ModelFit result() const;

private:
    bool isNoise(const SegmentFit &fit) const;
    std::optional<SegmentFit> fitted(const TrackSegment &segment, const BoardParameters &board) const;
    std::optional<SegmentFit> started(size_t first) const;
    void close();
    std::optional<SegmentFit> grown(const SegmentFit &fit);
    double length(size_t first, size_t last) const { return m_track.points[last].time - m_track.points[first].time; }
    size_t pointAfter(size_t first, double time) const;
    FittedValue valueOf(size_t i, const ModelFit &fit) const;
    void addResiduals(ModelFit &fit) const;
    void matchBounces(ModelFit &fit) const;
    bool endsAtWall(const TrackSegment &segment) const;

    const BallModel &m_model;
    const Track &m_track;
    BoardParameters m_board;
    double m_noise;
    const std::stop_token &m_stop;
    std::vector<FitQuantity> m_quantities;
    std::vector<FitQuantity> m_withoutEffect; ///< in this model
    BoardEstimate m_estimate;
    std::vector<TrackSegment> m_segments;
    std::optional<SegmentFit> m_growing;  ///< the segment being extended
    double m_stride = 0.0;                ///< s, by which it is extended next
    bool m_hasDiverged = false;           ///< even the next points disagree with the computed ball
    std::vector<TrackSegment> m_diverged; ///< segments at whose ends the computed and the measured ball diverge
    size_t m_next = 0;                    ///< first point not used yet
    size_t m_end = 0;                     ///< first point that isn't to be used
};

/// Tests the residuals as a whole and in every window: a mismatched bounce shows up only in a window.
bool SequentialFit::isNoise(const SegmentFit &fit) const {
    const size_t count = fit.residuals.size();
    const auto isNoiseIn = [&](size_t from, size_t to) {
        const double chance = 1.0 + kMostDeviations / std::sqrt(2.0 * double(to - from));
        return rmsOf(fit.residuals, from, to) < m_noise * kNoiseUncertainty * chance;
    };
    for (size_t from = 0; from < count; from += kWindow)
        if (!isNoiseIn(count > from + kWindow ? from : count - std::min(count, kWindow),
                       std::min(from + kWindow, count)))
            return false;
    return isNoiseIn(0, count);
}

std::optional<SegmentFit> SequentialFit::fitted(const TrackSegment &segment, const BoardParameters &board) const {
    std::optional<SegmentFit> fit = fitSegment(m_model, m_quantities, m_estimate, board, segment, m_noise, kSteps);
    return fit && isNoise(*fit) ? fit : std::nullopt;
}

size_t SequentialFit::pointAfter(size_t first, double time) const {
    size_t point = first;
    while (point + 1 < m_track.points.size() && length(first, point) < time) ++point;
    return point;
}

std::optional<SegmentFit> SequentialFit::started(size_t first) const {
    const size_t last = std::max(pointAfter(first, kFirstLength), first + kFewestPoints);
    if (last >= m_end) return std::nullopt;
    return fitted({first, last, startAt(m_track, m_board.frame, first), {}}, m_board);
}

/// Extends a segment by a stride that grows while the prediction holds and shrinks where it doesn't. Edges make
/// neighbouring paths diverge and create many local minima: where the fit so far doesn't predict the following points,
/// a new segment must begin. Returns nothing in that case, and where the computed ball diverges from the measured one.
std::optional<SegmentFit> SequentialFit::grown(const SegmentFit &fit) {
    const TrackSegment &segment = fit.segment;
    const bool isShort = segment.last - segment.first <= 3 * kFewestPoints;
    for (; m_stride >= kShortestStride; m_stride *= 0.5) {
        TrackSegment longer = segment;
        m_stride = std::min(m_stride, kLongestSegment - length(segment.first, segment.last));
        longer.last = std::min(pointAfter(segment.last, m_stride), m_end - 1);
        std::optional<SegmentFit> more = fitted(longer, fit.board);
        m_hasDiverged = !more;
        if (!more || !(isShort || isPredicted(m_model, m_quantities, m_estimate, fit, *more, m_noise))) continue;
        m_stride *= kStrideGrowth;
        return more;
    }
    return std::nullopt;
}

void SequentialFit::run(size_t first, size_t end, int mostBreaks, const FitProgress &progress) {
    m_next = first;
    m_end = std::min(end, m_track.points.size());
    const auto tell = [&](size_t point) {
        if (progress) progress(length(0, point) / length(0, m_end - 1), modelName(m_board.params.model));
    };
    while (m_next + kFewestPoints < m_end && breaks() < mostBreaks && !m_stop.stop_requested()) {
        tell(m_next);
        m_growing = started(m_next);
        if (!m_growing) { // perhaps within a bounce
            m_next = std::max(m_next + 3, smoothestAfter(m_track, m_next + 1, kReach));
            continue;
        }
        m_stride = std::max(m_stride, kFirstStride); // keep the stride of the previous segment
        m_hasDiverged = false;
        while (m_growing->segment.last + 1 < m_end &&
               length(m_growing->segment.first, m_growing->segment.last) < kLongestSegment &&
               !m_stop.stop_requested()) {
            std::optional<SegmentFit> more = grown(*m_growing);
            if (!more) break;
            m_growing = std::move(more);
            tell(m_growing->segment.last);
        }
        close();
    }
}

void SequentialFit::close() {
    if (m_hasDiverged) m_diverged.push_back(m_growing->segment);
    m_board = m_growing->board;
    m_estimate = m_growing->estimate;
    m_segments.push_back(m_growing->segment);
    m_next = m_growing->segment.last + 1;
    if (m_next + kFewestPoints < m_track.points.size()) m_next = smoothestAfter(m_track, m_next, kReach);
}

/// The first segments were fitted with a weak prior, so all are fitted again, starting from the final estimate with a
/// covariance inflated so that it hardly matters.
void SequentialFit::refine() {
    std::sort(m_segments.begin(), m_segments.end(),
              [](const TrackSegment &a, const TrackSegment &b) { return a.first < b.first; });
    for (std::vector<double> &row : m_estimate.covariance)
        for (double &number : row) number *= kInflation * kInflation;
    for (TrackSegment &segment : m_segments) {
        const std::optional<SegmentFit> fit = fitted(segment, m_board);
        if (!fit) continue; // no information from this segment
        segment = fit->segment;
        m_estimate = fit->estimate;
        m_board = fit->board;
    }
}

ModelFit SequentialFit::result() const {
    ModelFit fit;
    fit.model = m_board.params.model;
    fit.board = m_board;
    fit.segments = m_segments;
    fit.breaks = breaks();
    fit.breaksAtWalls = int(std::count_if(m_diverged.begin(), m_diverged.end(),
                                          [&](const TrackSegment &segment) { return endsAtWall(segment); }));
    addResiduals(fit);
    matchBounces(fit);
    const double allowed = std::max(1.0, kAllowedBreaks * double(fit.bounces.size()));
    fit.share = double(fit.residuals.size()) / double(m_track.points.size());
    for (const TrackSegment &segment : m_segments) fit.seconds += length(segment.first, segment.last);
    fit.isGood = fit.share >= ModelFit::kLeastShare && breaks() <= allowed;
    for (size_t i = 0; i < m_quantities.size(); ++i) fit.values.push_back(valueOf(i, fit));
    for (size_t i = 0; i < m_quantities.size(); ++i) {
        fit.correlations.emplace_back();
        for (size_t j = 0; j < m_quantities.size(); ++j)
            fit.correlations[i].push_back(m_estimate.covariance[i][j] /
                                          (m_estimate.deviation(i) * m_estimate.deviation(j)));
    }
    for (const FitQuantity &quantity : m_withoutEffect) {
        BoardParameters board = m_board;
        fit.values.push_back({quantity, quantity.of(board), quantity.priorDeviation,
                              QStringLiteral("no effect in the %1 model").arg(modelName(fit.model))});
    }
    return fit;
}

FittedValue SequentialFit::valueOf(size_t i, const ModelFit &fit) const {
    const FitQuantity &quantity = m_quantities[i];
    FittedValue value{quantity, m_estimate.mean[i], m_estimate.deviation(i), {}};
    const bool isOfWall =
        quantity.id == QLatin1String("restitution_wall") || quantity.id == QLatin1String("wall_friction");
    if (fit.share < ModelFit::kLeastShare)
        value.reason = QStringLiteral("too little of the track is explained");
    else if (isOfWall && !fit.bouncesOff(Surface::Wall))
        value.reason = QStringLiteral("no wall is hit");
    else if (quantity.id == QLatin1String("restitution_floor") && !fit.bouncesOff(Surface::Floor))
        value.reason = QStringLiteral("no bounce on the floor");
    else if (value.deviation > 0.5 * quantity.priorDeviation)
        value.reason = quantity.id == QLatin1String("delay") ? QStringLiteral("the tilt doesn't change")
                                                             : QStringLiteral("the track hardly feels it");
    return value;
}

/// Evaluates the final board, with the best start for each segment.
void SequentialFit::addResiduals(ModelFit &fit) const {
    std::vector<TrackPoint> computed;
    std::vector<TrackBounce> bounces;
    for (TrackSegment &segment : fit.segments) {
        if (fit.segments.size() > 1)
            if (const auto again = fitSegment(m_model, {}, {}, fit.board, segment, m_noise, kSteps))
                segment = again->segment;
        m_model.run(fit.board, segment.start, segment.first, segment.last, computed, &bounces);
        for (size_t i = 0; i < computed.size(); ++i)
            fit.residuals.push_back({m_track.points[segment.first + i], computed[i]});
    }
    for (const TrackBounce &bounce : bounces)
        if (bounce.speed >= kCountedImpact) fit.bounces.push_back({bounce});
}

/// Whether the computed ball bounces off a wall near the segment's end, after which the measured one goes elsewhere.
bool SequentialFit::endsAtWall(const TrackSegment &segment) const {
    std::vector<TrackPoint> computed;
    std::vector<TrackBounce> bounces;
    m_model.run(m_board, segment.start, segment.first, pointAfter(segment.last, kNearBreak), computed, &bounces);
    const double begin = m_track.points[segment.last].time - kNearBreak;
    return std::any_of(bounces.begin(), bounces.end(), [&](const TrackBounce &bounce) {
        return bounce.surface == Surface::Wall && bounce.time >= begin && bounce.speed >= kCountedImpact;
    });
}

/// Root mean square of the residuals of a coordinate at the wanted times, m; NaN without any.
template<typename Wanted>
double rmsAt(const std::vector<FitResidual> &residuals, Wanted isWanted) {
    double squares = 0.0;
    int count = 0;
    for (const FitResidual &residual : residuals) {
        if (!isWanted(residual.seen.time)) continue;
        squares +=
            std::pow(residual.seen.x - residual.computed.x, 2) + std::pow(residual.seen.y - residual.computed.y, 2);
        count += 2;
    }
    return std::sqrt(squares / count);
}

void SequentialFit::matchBounces(ModelFit &fit) const {
    for (FittedBounce &bounce : fit.bounces)
        bounce.isMatched = rmsAt(fit.residuals, [&](double time) {
                               return std::abs(time - bounce.time) <= kNearMatch;
                           }) < kMatched * m_noise;
    const auto isNear = [&](double time) {
        return std::any_of(fit.bounces.begin(), fit.bounces.end(), [&](const FittedBounce &bounce) {
            return time >= bounce.time && time <= bounce.time + ModelFit::kNear;
        });
    };
    fit.rms = rmsAt(fit.residuals, [](double) { return true; });
    fit.rmsNearBounces = rmsAt(fit.residuals, isNear);
    fit.rmsElsewhere = rmsAt(fit.residuals, [&](double time) { return !isNear(time); });
}

/// The initial board, and one with each further starting value of a quantity.
std::vector<BoardParameters> initialBoards(const FitPlan &plan, const BoardParameters &begin) {
    std::vector<BoardParameters> initialGuesses{begin};
    for (const FitQuantity &quantity : plan.quantities) {
        BoardParameters board = begin;
        for (const double guess : quantity.initialGuesses) {
            if (guess == quantity.of(board)) continue;
            initialGuesses.push_back(begin);
            quantity.of(initialGuesses.back()) = guess;
        }
    }
    return initialGuesses;
}

/// Tries a model on a short part of the track, from several places and starting values. Where it succeeds, the fit
/// continues to the end and then backwards to the beginning. The first attempt that explains the track is used,
/// otherwise the one that gets farthest before it is abandoned.
ModelFit fitModel(const FitPlan &plan, const BallModel &model, const BoardParameters &begin, double noise,
                  const FitProgress &progress, const std::stop_token &stop) {
    std::optional<ModelFit> best;
    const auto finish = [&](SequentialFit &attempt) {
        attempt.refine();
        ModelFit fit = attempt.result();
        if (!best || fit.isGood || fit.residuals.size() > best->residuals.size()) best = std::move(fit);
    };
    const size_t count = plan.track.points.size();
    int attempts = 0;
    for (const BoardParameters &guess : initialBoards(plan, begin)) {
        for (const double share : kTrialPlaces) {
            if (stop.stop_requested() || (best && best->isGood) || attempts == kMostAttempts) break;
            const auto from = size_t(share * double(count));
            SequentialFit attempt(plan, model, guess, noise, stop);
            attempt.run(from, from + size_t(kTrialLength / plan.track.period()), 1, {});
            if (!attempt.hasBegun() || attempt.breaks() > 0) continue;
            attempt.run(attempt.next(), count, kMostBreaks, progress);
            attempt.run(0, from, kMostBreaks, progress);
            finish(attempt);
            ++attempts;
        }
    }
    if (best && best->isGood) return *best;
    SequentialFit last(plan, model, begin, noise, stop);
    last.run(0, count, kMostBreaks, progress);
    finish(last);
    return *best;
}

FitVerdict verdictOf(const std::vector<ModelFit> &fits) {
    for (const ModelFit &fit : fits)
        if (fit.isGood)
            return fit.determinesNothing()           ? FitVerdict::Undetermined
                   : fit.model == PHYS_MODEL_ROLLING ? FitVerdict::RollingSuffices
                                                     : FitVerdict::RigidNeeded;
    return FitVerdict::Neither;
}

} // namespace

std::optional<BallStart> ModelFit::start() const {
    const bool isFromTheFirst = !segments.empty() && segments.front().first == 0;
    return isFromTheFirst ? std::optional(segments.front().start) : std::nullopt;
}

bool ModelFit::bouncesOff(Surface surface) const {
    return std::any_of(bounces.begin(), bounces.end(),
                       [surface](const FittedBounce &bounce) { return bounce.surface == surface; });
}

bool ModelFit::determinesNothing() const {
    return !values.empty() &&
           std::none_of(values.begin(), values.end(), [](const FittedValue &value) { return value.isDetermined(); });
}

const ModelFit &TrackFit::best() const {
    const auto isWorse = [](const ModelFit &a, const ModelFit &b) {
        return std::tuple(a.isGood, a.share, -a.breaks) < std::tuple(b.isGood, b.share, -b.breaks);
    };
    return *std::ranges::max_element(fits, isWorse);
}

std::optional<TrackFit> fitTrack(const FitPlan &plan, const FitProgress &progress, const std::stop_token &stop,
                                 QString *error) {
    const BallModel model(plan.registry, plan.scene, plan.track, error);
    if (!model.isReady()) return std::nullopt;
    TrackFit result;
    result.noise = std::max(noiseOf(plan.track), kLeastNoise);
    std::vector<uint32_t> models{PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID};
    if (plan.model) models = {*plan.model};
    BoardParameters begin = plan.begin;
    for (const uint32_t kind : models) {
        if (!result.fits.empty() && result.fits.back().isGood) break;
        begin.params.model = kind;
        result.fits.push_back(fitModel(plan, model, begin, result.noise, progress, stop));
        // Tilt and delay are about the same in the other model.
        begin.tiltOffset = result.fits.back().board.tiltOffset;
        begin.delay = result.fits.back().board.delay;
    }
    if (stop.stop_requested()) {
        *error = QStringLiteral("stopped");
        return std::nullopt;
    }
    result.verdict = verdictOf(result.fits);
    result.beside = pointsBeside(plan.track, result.best().board.frame, plan.scene.get());
    result.points = plan.track.points.size();
    result.duration = plan.track.end() - plan.track.begin();
    return result;
}

} // namespace inspector
