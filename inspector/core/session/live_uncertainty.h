// SPDX-License-Identifier: GPL-3.0-or-later
// How well one can know where the ball is, beside the comparison: what isn't known of the board, from the place where
// ball and ghost met, under the tilts that there were since.
#pragma once

#include "core/simulation/sample_ring.h"
#include "core/simulation/snapshot.h"
#include "core/trade/live_band.h"

namespace inspector {

class LiveUncertainty {
public:
    explicit LiveUncertainty(Registry registry)
        : m_band(std::move(registry)) {}

    // Called now and then while somebody looks; what there was since the last time is made up for. samples: of the run
    // that the snapshot shows, on this scene; nothing unknown: no band. Of the past nothing new is to be learned: not
    // called then.
    void follow(const Snapshot &now, const SampleRing &samples, const Scene &scene, const Unknowns &unknowns);
    // Waits until the band goes as far as what was followed: for a picture, otherwise it comes a little later.
    void finish();
    // Null without one. Another pointer: another band.
    std::shared_ptr<const Band> band() const { return m_band.latest(); }

private:
    bool isOfBand(const Snapshot &now, const Scene &scene, const Unknowns &unknowns) const;
    bool begin(const Snapshot &now, const SampleRing &samples, const Scene &scene, const Unknowns &unknowns);
    void end();
    void take(const Sample &sample, const Inputs &inputs, std::vector<LiveBand::Segment> &segments);

    LiveBand m_band;
    // What the present band is of; without a scene there is none.
    Scene m_scene;
    phys_state m_met{};
    uint64_t m_run = 0;
    Unknowns m_unknowns;
    bool m_isWhole = true; // its samples are all there
    uint64_t m_next = 0;   // sample
    double m_time = 0.0;   // s, of the sample before
    // Not over yet. Pieces end where the samples say, so that a band doesn't depend on when somebody looked.
    std::optional<LiveBand::Segment> m_open;
};

} // namespace inspector
