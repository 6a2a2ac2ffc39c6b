// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/live_band.h"

#include "core/trade/ball_ensemble.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

namespace inspector {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongestStep = 0.05; ///< s, of "exact", so that a band is smooth while tilts are constant
constexpr Clock::duration kShown = std::chrono::milliseconds(50);

/// The nominal board, followed by the sampled ones.
std::vector<SampledBoard> boardsOf(const Unknowns &unknowns, const Inputs &inputs) {
    std::vector<SampledBoard> boards = sampleBoards(unknowns, inputs, LiveBand::kBalls, kBandSeed);
    boards.insert(boards.begin(), SampledBoard{inputs.params, inputs.gravity, {}, {}});
    return boards;
}

/// Compares bytes, as neither type has padding; the tilt isn't a property of the board.
bool isSameBoard(const Inputs &a, const Inputs &b) {
    phys_params one = a.params;
    phys_params other = b.params;
    one.gravity = other.gravity = {};
    return a.gravity == b.gravity && std::memcmp(&one, &other, sizeof one) == 0;
}

} // namespace

/// The state of one band's computation.
struct LiveBand::Work {
    Start start;
    uint64_t number;
    double radius = phys_scene_radius(start.scene.get());
    std::optional<BallEnsemble> balls{};
    Inputs inputs{};
    double time = start.state.time;
    Band band{};

    bool isOver() const { return time >= start.state.time + kReach; }

    void take(const Stepper &stepper, const Inputs &now) {
        if (balls && isSameBoard(inputs, now)) return;
        inputs = now;
        const std::vector<SampledBoard> boards = boardsOf(start.unknowns, now);
        if (balls) return balls->setBoards(boards);
        balls.emplace(stepper, start.scene, boards, start.state);
        note();
    }

    void note() {
        std::vector<double> distances = balls->distancesFrom(balls->centre(0));
        if (std::isnan(distances.front())) return; // no nominal ball to compare with
        distances.erase(distances.begin());
        appendQuantiles(band, time, std::move(distances), radius);
    }

    void step(const Segment &segment) {
        const double count = std::ceil(segment.length / kLongestStep);
        for (int i = 0; i < int(count); ++i) {
            balls->step(segment.inputs.tilt, segment.length / count, 1);
            time += segment.length / count;
            if (band.isEmpty() || time >= band.times.back() + kInterval) note();
        }
    }
};

LiveBand::LiveBand(Registry registry)
    : m_registry(std::move(registry))
    , m_thread([this](const std::stop_token &stop) { work(stop); }) {}

LiveBand::~LiveBand() {
    m_thread.request_stop();
    m_thread.join();
}

void LiveBand::begin(Start start) {
    {
        const std::lock_guard lock(m_mutex);
        m_start = std::move(start);
        ++m_number;
        m_segments.clear();
        m_band.reset();
    }
    m_wake.notify_one();
}

void LiveBand::goOn(const std::vector<Segment> &segments) {
    {
        const std::lock_guard lock(m_mutex);
        m_segments.insert(m_segments.end(), segments.begin(), segments.end());
    }
    m_wake.notify_one();
}

void LiveBand::end() {
    const std::lock_guard lock(m_mutex);
    m_start.reset();
    ++m_number;
    m_segments.clear();
    m_band.reset();
}

void LiveBand::finish() {
    std::unique_lock lock(m_mutex);
    m_hurries = true;
    m_wake.notify_one();
    m_idle.wait(lock, [this] { return !m_start || (m_segments.empty() && !m_isBusy); });
    m_hurries = false;
}

std::shared_ptr<const Band> LiveBand::latest() const {
    const std::lock_guard lock(m_mutex);
    return m_band;
}

/// Ignored if the band was dropped meanwhile.
void LiveBand::publish(uint64_t number, const Band &band) {
    auto copy = std::make_shared<const Band>(band);
    const std::lock_guard lock(m_mutex);
    if (number == m_number) m_band = std::move(copy);
}

void LiveBand::work(const std::stop_token &stop) {
    std::optional<Work> now;
    while (!stop.stop_requested()) {
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, stop, [this] { return m_start && !m_segments.empty(); });
            if (!m_start) continue;
            if (!now || now->number != m_number) now.emplace(Work{*m_start, m_number});
            m_isBusy = true;
        }
        const Clock::time_point begin = Clock::now();
        compute(*now, stop);
        const auto rest = std::chrono::duration_cast<Clock::duration>(kRest * (Clock::now() - begin));
        std::unique_lock lock(m_mutex);
        m_isBusy = false;
        m_idle.notify_one();
        m_wake.wait_for(lock, stop, rest, [this] { return m_hurries; });
    }
}

/// Processes the queue or part of it; the next call continues.
void LiveBand::compute(Work &work, const std::stop_token &stop) {
    std::vector<Segment> segments;
    {
        const std::lock_guard lock(m_mutex);
        if (work.number == m_number) segments.swap(m_segments);
    }
    const Stepper stepper = work.balls ? Stepper() : makeStepper(m_registry, "exact", work.start.scene, nullptr);
    if (!work.balls && !stepper) return;
    const Clock::time_point end = Clock::now() + kShown;
    size_t done = 0;
    for (; done < segments.size() && !stop.stop_requested() && !work.isOver() && Clock::now() < end; ++done) {
        work.take(stepper, segments[done].inputs);
        work.step(segments[done]);
    }
    if (done > 0) publish(work.number, work.band);
    if (work.isOver()) return;
    const std::lock_guard lock(m_mutex);
    if (work.number == m_number)
        m_segments.insert(m_segments.begin(), segments.begin() + ptrdiff_t(done), segments.end());
}

} // namespace inspector
