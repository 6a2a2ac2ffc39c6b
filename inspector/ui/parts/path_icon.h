// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace inspector::ui {

enum class Glyph {
    Run,
    Pause,
    Step,
    StepBack,
    BounceBack,
    BounceOn,
    Begin,
    Restart,
    End,
    Autopilot,
    Reset,
    Close,
    Warning,
    Clear,
    Save,
    Open,
    Follow,
    Add,
    More
};

/// A line drawing in the current palette's text colour, sharp at every size and resolution.
QIcon glyphIcon(Glyph glyph);

} // namespace inspector::ui
