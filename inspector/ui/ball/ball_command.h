// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

class QUndoStack;

namespace inspector::ui {

// The ball was put to a place by hand, where it is already: one undo takes all of it back.
void pushBallCommand(Session &session, QUndoStack &undo, const phys_state &before, const phys_state &after);

} // namespace inspector::ui
