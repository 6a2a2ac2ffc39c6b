// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

class QUndoStack;

namespace inspector::ui {

/// Changes stepper, step size and settings as one undo step. text: the menu text. False if the session refused and
/// reported it.
bool changeStepping(Session &session, QUndoStack &undo, const Stepping &wanted, const QString &text);

} // namespace inspector::ui
