// SPDX-License-Identifier: GPL-3.0-or-later
// The board on which the computed ball rolls like a measured one.
#pragma once

#include "core/track/segment_fit.h"

#include <functional>
#include <optional>
#include <stop_token>

namespace inspector {

struct FitPlan {
    Registry registry;
    Scene scene;
    Track track;
    BoardParameters begin; // what isn't looked for stays as it is here
    std::vector<FitQuantity> quantities;
    // Only this model; otherwise the rolling one, and the rigid one if that doesn't fit.
    std::optional<uint32_t> model;
};

// A number that was looked for; SI.
struct FittedValue {
    FitQuantity quantity;
    double value;
    double deviation; // standard
    QString reason;   // why the track doesn't determine it; empty if it does

    bool isDetermined() const { return reason.isEmpty(); }
    double halfInterval() const { return 1.96 * deviation; } // 95 of 100 such intervals hold the truth
};

// A point of the track beside the computed one: m, in the tracker's frame.
struct FitResidual {
    TrackPoint seen, computed;
};

struct FittedBounce : TrackBounce {
    bool isMatched = false; // what was measured around it is as computed
};

struct ModelFit {
    uint32_t model;
    BoardParameters board;
    std::vector<TrackSegment> segments; // one if the whole track is described at once
    int breaks = 0;                     // moments at which the computed ball and the measured one part
    int breaksAtWalls = 0;              // of these, those with a bounce off one
    std::vector<FittedValue> values;
    std::vector<std::vector<double>> correlations; // between values
    double rms = 0.0;                              // m
    bool isGood = false;                           // the model explains the track
    std::vector<FitResidual> residuals;
    std::vector<FittedBounce> bounces;
    double rmsNearBounces = 0.0; // m, within kNear of one
    double rmsElsewhere = 0.0;

    static constexpr double kNear = 0.25; // s, after a bounce

    bool bouncesOff(Surface surface) const;
};

enum class FitVerdict { RollingSuffices, RigidNeeded, Neither };

struct TrackFit {
    double noise = 0.0;         // m, of the tracker
    std::vector<ModelFit> fits; // as far as they were needed: rolling, rigid
    FitVerdict verdict = FitVerdict::Neither;

    const ModelFit &best() const; // that of the verdict; of neither, the one with fewer breaks
};

using FitProgress = std::function<void(double share, const QString &what)>;

// Takes about a second. Nothing and one line in `error` if there is nothing to fit with, or it was stopped.
std::optional<TrackFit> fitTrack(const FitPlan &plan, const FitProgress &progress, const std::stop_token &stop,
                                 QString *error);

} // namespace inspector
