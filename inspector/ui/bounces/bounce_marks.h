// SPDX-License-Identifier: GPL-3.0-or-later
// Bounces in the 3D view: drawing and picking.
#pragma once

#include "core/events/event_log.h"
#include "gl/view/maze_view.h"

#include <optional>
#include <vector>

namespace inspector::ui {

/// The drawn entries of the log.
struct BounceMarks {
    std::vector<LoggedEvent> recent; ///< oldest first; older ones are fainter
    std::optional<LoggedEvent> selected;
};

/// Adds each entry's point and normal; those of the selected one are larger and shown with its box.
void addMarks(gl::Strokes &strokes, const BounceMarks &marks, const phys_scene *scene);

/// The number of the entry whose mark is nearest to the ray on the screen, within a few pixels. Marks whose point and
/// normal are both hidden are ignored.
std::optional<uint64_t> markAt(const gl::MazeView &view, const gl::Ray &ray, const BounceMarks &marks,
                               const phys_scene *scene);

} // namespace inspector::ui
