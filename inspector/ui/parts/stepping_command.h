// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

class QUndoStack;

namespace inspector::ui {

// Changes how steps are made; one undo takes all of it back. text: what was done, for the menu. False if the session
// refused, which it has said.
bool changeStepping(Session &session, QUndoStack &undo, const Stepping &wanted, const QString &text);

} // namespace inspector::ui
