// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/parameters.h"

#include <QUndoCommand>

#include <vector>

namespace inspector::ui {

/// One edit of parameters by the user. Edits of one row within one gesture (a drag, a turn of the wheel) are merged.
class ParameterCommand : public QUndoCommand {
public:
    /// The parameters already have the values of `after`. gesture: edits with different numbers aren't merged.
    ParameterCommand(Parameters &parameters, std::vector<Setting> before, std::vector<Setting> after, int gesture,
                     const QString &text);

    void undo() override { apply(m_before); }
    void redo() override { apply(m_after); }
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand *later) override;

private:
    void apply(const std::vector<Setting> &settings);

    Parameters &m_parameters;
    std::vector<Setting> m_before;
    std::vector<Setting> m_after;
    int m_gesture;
};

} // namespace inspector::ui
