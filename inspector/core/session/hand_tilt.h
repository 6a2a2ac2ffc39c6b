// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pilot/tilt_control.h"
#include "core/setup/parameters.h"

#include <vector>

namespace inspector {

/// The board's tilt as the player's keys set it, or as it was when a moment was taken over.
class HandTilt {
public:
    /// parameters: their tilt is set; must outlive this object.
    explicit HandTilt(Parameters &parameters);

    void setKeys(TiltKeys keys) { m_control.setKeys(keys); }
    TiltKeys keys() const { return m_control.keys(); }
    void releaseKeys(); ///< they have no effect until they are set again; the tilt stays
    /// seconds: since the last call. While a key is held, and until the board is level again, the tilt follows the
    /// keys.
    void advance(double seconds);
    bool isByKeys() const { return m_isByKeys; }
    void level(); ///< also releases the keys

    /// A moment with the settings `taken` is taken over by a ball with the settings `before`. A tilt that these have
    /// was set by hand and stays; the one taken over ends with the run.
    void takeOver(const std::vector<Setting> &taken, const std::vector<Setting> &before);
    /// Whether the board has the tilt taken over, unchanged since; forgets it.
    bool endTaken();
    void set(Tilt tilt);

private:
    Parameters &m_parameters;
    TiltControl m_control;
    bool m_isByKeys = false;
    std::vector<Setting> m_taken; ///< empty: none
};

} // namespace inspector
