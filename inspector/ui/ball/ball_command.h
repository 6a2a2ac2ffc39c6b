// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

class QUndoStack;

namespace inspector::ui {

/// Pushes a command for a ball that the user has already moved; a single undo reverts all of it. before: the moment at
/// which the user did.
void pushBallCommand(Session &session, QUndoStack &undo, const Snapshot &before, const phys_state &after);

} // namespace inspector::ui
