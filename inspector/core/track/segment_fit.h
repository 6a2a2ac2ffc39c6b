// SPDX-License-Identifier: GPL-3.0-or-later
// Nonlinear least squares of positions over one segment of a track: fits board quantities and the segment's start.
#pragma once

#include "core/track/fit_quantity.h"
#include "core/track/track_segment.h"

namespace inspector {

/// A Gaussian estimate of the quantities: the prior of one segment's fit is the posterior of the one before.
struct BoardEstimate {
    std::vector<double> mean;
    std::vector<std::vector<double>> covariance;

    double deviation(size_t i) const;
};

/// A weak prior: each quantity around its current value, as uncertain as its range allows.
BoardEstimate weakPrior(const std::vector<FitQuantity> &quantities, const BoardParameters &board);

struct SegmentFit {
    BoardParameters board;
    TrackSegment segment;
    BoardEstimate estimate;        ///< posterior, after the segment
    std::vector<double> residuals; ///< m, x and y of each point in turn

    /// Solution of the scaled problem (the quantities, then the start's four numbers), with its covariance and the
    /// Jacobian of the residuals in units of the noise.
    std::vector<double> numbers;
    std::vector<std::vector<double>> triangularFactor; ///< R of J = Q R; the covariance is R^-1 R^-T
    std::vector<std::vector<double>> jacobian;         ///< a row per residual
};

/// Levenberg-Marquardt by GSL, at most `steps` steps, starting from the given board and start; noise: of a coordinate,
/// m. Returns nothing if the linear algebra fails.
std::optional<SegmentFit> fitSegment(const BallModel &model, const std::vector<FitQuantity> &quantities,
                                     const BoardEstimate &before, const BoardParameters &board,
                                     const TrackSegment &segment, double noise, int steps);

/// Whether the fit `before` predicted the ball at the points that `after` adds, and did so nearly linearly, so that its
/// covariance is meaningful: within the uncertainty no edge is hit in one case and missed in another. before, after:
/// fits of the same segment with the same prior.
bool isPredicted(const BallModel &model, const std::vector<FitQuantity> &quantities, const BoardEstimate &estimate,
                 const SegmentFit &before, const SegmentFit &after, double noise);

} // namespace inspector
