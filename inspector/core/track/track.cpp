// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/track.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

double medianOf(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Third differences of equally spaced positions, m; gaps are skipped.
std::vector<double> thirdDifferences(const Track &track) {
    const double usual = 1.5 * track.period();
    std::vector<double> lengths;
    for (size_t i = 3; i < track.points.size(); ++i) {
        const TrackPoint *const p = &track.points[i - 3];
        if (p[1].time - p[0].time > usual || p[2].time - p[1].time > usual || p[3].time - p[2].time > usual) continue;
        lengths.push_back(
            std::hypot(p[3].x - 3.0 * p[2].x + 3.0 * p[1].x - p[0].x, p[3].y - 3.0 * p[2].y + 3.0 * p[1].y - p[0].y));
    }
    return lengths;
}

} // namespace

double Track::period() const {
    std::vector<double> periods;
    for (size_t i = 1; i < points.size(); ++i) periods.push_back(points[i].time - points[i - 1].time);
    return medianOf(std::move(periods));
}

void TrackFrame::toBoard(double trackX, double trackY, double &boardX, double &boardY) const {
    const double c = scale * std::cos(angle);
    const double s = scale * std::sin(angle);
    boardX = x + c * trackX - s * trackY;
    boardY = y + s * trackX + c * trackY;
}

void TrackFrame::toTrack(double boardX, double boardY, double &trackX, double &trackY) const {
    const double c = std::cos(angle) / scale;
    const double s = std::sin(angle) / scale;
    trackX = c * (boardX - x) + s * (boardY - y);
    trackY = -s * (boardX - x) + c * (boardY - y);
}

size_t pointsBeside(const Track &track, const TrackFrame &frame, const phys_scene *scene) {
    phys_box bounds;
    phys_scene_bounds(scene, &bounds);
    return size_t(std::count_if(track.points.begin(), track.points.end(), [&](const TrackPoint &point) {
        double x = 0.0;
        double y = 0.0;
        frame.toBoard(point.x, point.y, x, y);
        return x < bounds.min.x || x > bounds.max.x || y < bounds.min.y || y > bounds.max.y;
    }));
}

double noiseOf(const Track &track) {
    constexpr double kOfThirdDifference = 4.47213595499958; // sqrt(1 + 9 + 9 + 1), of independent numbers
    constexpr double kOfPlane = 1.1774100225154747;         // the median distance from 0, in deviations of a coordinate
    constexpr double kBounce = 3.5;                         // times the median: a bounce, not noise
    constexpr size_t kBeside = 2;                           // neighbouring differences that a bounce affects
    constexpr int kPasses = 4;
    std::vector<double> lengths = thirdDifferences(track);
    std::vector<bool> isSmooth(lengths.size(), true);
    double median = 0.0;
    for (int pass = 0; pass < kPasses; ++pass) {
        std::vector<double> smooth;
        for (size_t i = 0; i < lengths.size(); ++i)
            if (isSmooth[i]) smooth.push_back(lengths[i]);
        median = medianOf(std::move(smooth));
        for (size_t i = 0; i < lengths.size(); ++i) {
            if (lengths[i] <= kBounce * median) continue;
            const size_t end = std::min(i + kBeside + 1, lengths.size());
            for (size_t j = i > kBeside ? i - kBeside : 0; j < end; ++j) isSmooth[j] = false;
        }
    }
    return median / (kOfPlane * kOfThirdDifference);
}

} // namespace inspector
