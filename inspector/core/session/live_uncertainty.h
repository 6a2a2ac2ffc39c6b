// SPDX-License-Identifier: GPL-3.0-or-later
// The uncertainty band of the live comparison: what isn't known of the board, from the point where ball and ghost
// started, under the tilts since then.
#pragma once

#include "core/simulation/sample_ring.h"
#include "core/simulation/snapshot.h"
#include "core/trade/live_band.h"

namespace inspector {

class LiveUncertainty {
public:
    explicit LiveUncertainty(Registry registry)
        : m_band(std::move(registry)) {}

    /// Called from time to time; notes what happened since the last call, for band(). samples: of the run that the
    /// snapshot shows, in this scene. There is no band if nothing is unknown. Not called while the past is shown.
    void follow(const Snapshot &now, const SampleRing &samples, const Scene &scene, const Unknowns &unknowns);
    /// Waits until the band is up to date, for a picture; otherwise it lags a little.
    void finish();
    /// As far as it is computed, which happens only while this is called: while the band is seen. Null if there is
    /// none. Every update has a new pointer.
    std::shared_ptr<const Band> band();

private:
    bool isOfBand(const Snapshot &now, const Scene &scene, const Unknowns &unknowns) const;
    bool begin(const Snapshot &now, const SampleRing &samples, const Scene &scene, const Unknowns &unknowns);
    void end();
    void take(const Sample &sample, const Inputs &inputs);
    void computeNoted();

    LiveBand m_band;
    /// What the current band belongs to; none if there is no scene.
    Scene m_scene;
    uint64_t m_meetings = 0; ///< of the ghost with the ball: the same state can begin two runs
    Unknowns m_unknowns;
    bool m_isWhole = true; ///< no samples are missing
    uint64_t m_next = 0;   ///< number of the next sample
    double m_time = 0.0;   ///< s, of the previous sample
    double m_end = 0.0;    ///< s, of the band
    /// The segment being extended. Segments end at samples, so that a band doesn't depend on when update() was called.
    std::optional<LiveBand::Segment> m_open;
    std::vector<LiveBand::Segment> m_noted; ///< not computed yet
};

} // namespace inspector
