// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/shown_track.h"

#include "core/track/track_segment.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

constexpr double kJoined = 2.5;        ///< periods: a larger distance is a gap
constexpr size_t kAround = 2;          ///< points on either side used for a velocity
constexpr double kTiltRounding = 1e-9; ///< s
constexpr double kSoonAfter = 1.0;     ///< s

} // namespace

double usualBegin(const Track &track) {
    return track.begin() >= 0.0 && track.begin() < kSoonAfter ? track.begin() : 0.0;
}

ShownTrack::ShownTrack(const Track &track, const BoardParameters &board, double begin,
                       const std::optional<BallStart> &start)
    : m_start(start ? *start : startAt(track, board.frame, 0))
    , m_longest(kJoined * track.period()) {
    const double shift = begin - track.begin();
    for (const TrackPoint &point : track.points) {
        TrackPoint shown{point.time + shift, 0.0, 0.0};
        board.frame.toBoard(point.x, point.y, shown.x, shown.y);
        m_points.push_back(shown);
    }
    for (const TiltChange &change : track.tilts)
        m_tilts.push_back({change.time + board.delay + shift,
                           {change.tilt.x + board.tiltOffset.x, change.tilt.y + board.tiltOffset.y}});
}

std::optional<ShownTrack::Place> ShownTrack::at(double time) const {
    const auto after = std::upper_bound(m_points.begin(), m_points.end(), time,
                                        [](double now, const TrackPoint &point) { return now < point.time; });
    if (after == m_points.begin()) return std::nullopt;
    const auto before = size_t(after - m_points.begin()) - 1;
    const size_t next = std::min(before + 1, m_points.size() - 1);
    const TrackPoint &a = m_points[before];
    const TrackPoint &b = m_points[next];
    if (b.time - a.time > m_longest || (next == before && time > a.time)) return std::nullopt;
    const double share = next == before ? 0.0 : (time - a.time) / (b.time - a.time);
    const TrackPoint &from = m_points[before - std::min(before, kAround)];
    const TrackPoint &to = m_points[std::min(next + kAround, m_points.size() - 1)];
    const double span = to.time - from.time;
    if (!(span > 0.0)) return std::nullopt;
    return Place{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), (to.x - from.x) / span, (to.y - from.y) / span};
}

/// A switch at either end, up to rounding, doesn't count as being between.
Tilt ShownTrack::tiltBetween(double begin, double end) const {
    auto next = std::upper_bound(m_tilts.begin(), m_tilts.end(), begin + kTiltRounding,
                                 [](double now, const TiltChange &change) { return now < change.time; });
    Tilt now = next == m_tilts.begin() ? m_tilts.front().tilt : std::prev(next)->tilt;
    double from = begin;
    Tilt sum{};
    const auto addUntil = [&](double to) {
        sum = {sum.x + now.x * (to - from), sum.y + now.y * (to - from)};
        from = to;
    };
    for (; next != m_tilts.end() && next->time < end - kTiltRounding; ++next) {
        addUntil(next->time);
        now = next->tilt;
    }
    if (from == begin) return now;
    addUntil(end);
    return {sum.x / (end - begin), sum.y / (end - begin)};
}

phys_state ShownTrack::start(const phys_scene *scene) const { return rollingState(scene, m_start); }

void ShownTrack::addTo(Sample &sample) const {
    const std::optional<Place> place = at(sample.time);
    if (!place) return;
    sample[Channel::TrackX] = place->x;
    sample[Channel::TrackY] = place->y;
    sample[Channel::TrackSpeed] = std::hypot(place->vx, place->vy);
    sample[Channel::TrackDistance] =
        std::hypot(sample[Channel::PositionX] - place->x, sample[Channel::PositionY] - place->y);
}

} // namespace inspector
