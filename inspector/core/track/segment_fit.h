// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares of positions over one segment of a track: numbers of the board and the segment's start.
#pragma once

#include "core/track/fit_quantity.h"
#include "core/track/track_segment.h"

namespace inspector {

// What is known of the quantities before a segment is looked at: normally distributed around a mean.
struct BoardEstimate {
    std::vector<double> mean;
    std::vector<std::vector<double>> covariance;

    double deviation(size_t i) const;
};

// Next to nothing: each quantity about where it is set, as far off as the range that it may be in allows.
BoardEstimate weakPrior(const std::vector<FitQuantity> &quantities, const BoardParameters &board);

struct SegmentFit {
    BoardParameters board;
    TrackSegment segment;
    BoardEstimate estimate;        // after the segment
    std::vector<double> residuals; // m, x and y of each point in turn

    // The quantities and the start's four numbers, all as the solver scales them: where it ended, with their covariance
    // and the residuals' jacobian in units of the noise.
    std::vector<double> numbers;
    std::vector<std::vector<double>> triangularFactor; // R of J = Q R, whose covariance is R^-1 R^-T
    std::vector<std::vector<double>> jacobian;         // by residual
};

// By Levenberg and Marquardt's method from GSL, at most so many steps. Begins at the board and the start given; noise:
// of a coordinate, m. Nothing if the linear algebra fails.
std::optional<SegmentFit> fitSegment(const BallModel &model, const std::vector<FitQuantity> &quantities,
                                     const BoardEstimate &before, const BoardParameters &board,
                                     const TrackSegment &segment, double noise, int steps);

// Whether a fit told where the ball would be at points that were added since, and so nearly in proportion that its
// deviations mean something: within its uncertainty no edge is hit or missed. before, after: of one segment and with
// the same estimate from before it.
bool isPredicted(const BallModel &model, const std::vector<FitQuantity> &quantities, const BoardEstimate &estimate,
                 const SegmentFit &before, const SegmentFit &after, double noise);

} // namespace inspector
