// SPDX-License-Identifier: GPL-3.0-or-later
// Bounces in the 3D view: drawn, and found again under the mouse.
#pragma once

#include "core/events/event_log.h"
#include "gl/view/maze_view.h"

#include <optional>
#include <vector>

namespace inspector::ui {

// What of the log is drawn.
struct BounceMarks {
    std::vector<LoggedEvent> recent; // oldest first: the older, the fainter
    std::optional<LoggedEvent> selected;
};

// A point and its normal for each; the selected one larger, with its box.
void addMarks(gl::Strokes &strokes, const BounceMarks &marks, const phys_scene *scene);

// Number of the entry whose mark is nearest to where the ray meets the screen, within a few pixels. One of which
// neither point nor normal can be seen from there doesn't count.
std::optional<uint64_t> markAt(const gl::MazeView &view, const gl::Ray &ray, const BounceMarks &marks,
                               const phys_scene *scene);

} // namespace inspector::ui
