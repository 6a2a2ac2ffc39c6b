// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the board parameters with which the computed ball follows a measured one.
#pragma once

#include "core/track/segment_fit.h"

#include <functional>
#include <limits>
#include <optional>
#include <stop_token>

namespace inspector {

struct FitPlan {
    Registry registry;
    Scene scene;
    Track track;
    BoardParameters begin; ///< initial values; what isn't fitted keeps them
    std::vector<FitQuantity> quantities;
    /// Only this model; if empty, the rolling one, then the rigid one if that doesn't fit.
    std::optional<uint32_t> model;
};

/// A fitted quantity; SI.
struct FittedValue {
    FitQuantity quantity;
    double value;
    double deviation; ///< standard
    QString reason;   ///< why the track doesn't determine it; empty if it does

    bool isDetermined() const { return reason.isEmpty(); }
    double halfInterval() const { return 1.96 * deviation; } ///< of the 95 % confidence interval
};

/// A measured point and the corresponding computed one: m, in the tracker's frame.
struct FitResidual {
    TrackPoint seen, computed;
};

struct FittedBounce : TrackBounce {
    bool isMatched = false; ///< the measurements around it agree with the computed ball
};

struct ModelFit {
    uint32_t model;
    BoardParameters board;
    std::vector<TrackSegment> segments;            ///< a single one if it covers the whole track
    int breaks = 0;                                ///< moments at which the computed ball and the measured one diverge
    int breaksAtWalls = 0;                         ///< of these, those at a bounce off a wall
    double share = 0.0;                            ///< of the track's points, that lie in a segment
    double seconds = 0.0;                          ///< of the track, within segments
    std::vector<FittedValue> values;               ///< last those on which the model doesn't depend
    std::vector<std::vector<double>> correlations; ///< between the fitted values
    double rms = std::numeric_limits<double>::quiet_NaN(); ///< m; this and the next two: NaN without a residual
    bool isGood = false;                                   ///< the model explains the track
    std::vector<FitResidual> residuals;
    std::vector<FittedBounce> bounces;
    double rmsNearBounces = std::numeric_limits<double>::quiet_NaN(); ///< m, within kNear of one
    double rmsElsewhere = std::numeric_limits<double>::quiet_NaN();

    static constexpr double kNear = 0.25;      ///< s, after a bounce
    static constexpr double kLeastShare = 0.5; ///< of the points, below which a model explains nothing

    /// Of the computed ball at the track's first point; empty if no segment begins there.
    std::optional<BallStart> start() const;
    bool bouncesOff(Surface surface) const;
    bool determinesNothing() const;
};

/// Undetermined: a model explains the track, which tells nothing about what was looked for (a ball at rest).
enum class FitVerdict { RollingSuffices, RigidNeeded, Undetermined, Neither };

struct TrackFit {
    double noise = 0.0;         ///< m, of the tracker
    size_t beside = 0;          ///< points outside of the board
    size_t points = 0;          ///< of the track
    double duration = 0.0;      ///< s, of the track
    std::vector<ModelFit> fits; ///< those that were needed: rolling, rigid
    FitVerdict verdict = FitVerdict::Neither;

    bool isExplained() const { return verdict == FitVerdict::RollingSuffices || verdict == FitVerdict::RigidNeeded; }

    /// The fit that the verdict is about; if neither model fits, the one that explains more of the track.
    const ModelFit &best() const;
};

using FitProgress = std::function<void(double share, const QString &what)>;

/// Takes about a second. Returns nothing, with one line in `error`, if no fit is possible or it was stopped.
std::optional<TrackFit> fitTrack(const FitPlan &plan, const FitProgress &progress, const std::stop_token &stop,
                                 QString *error);

} // namespace inspector
