// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/parameter_command.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace inspector::ui {

ParameterCommand::ParameterCommand(Parameters &parameters, std::vector<Setting> before, std::vector<Setting> after,
                                   int gesture, const QString &text)
    : QUndoCommand(text)
    , m_parameters(parameters)
    , m_before(std::move(before))
    , m_after(std::move(after))
    , m_gesture(gesture) {}

bool ParameterCommand::mergeWith(const QUndoCommand *later) {
    const auto *other = static_cast<const ParameterCommand *>(later); // the same id() means the same class
    const bool isSameRow = m_after.size() == 1 && other->m_after.size() == 1 && m_after[0].id == other->m_after[0].id;
    if (&m_parameters != &other->m_parameters || !isSameRow || m_gesture != other->m_gesture) return false;
    m_after = other->m_after;
    setObsolete(m_after[0].value == m_before[0].value);
    return true;
}

/// Skips rows of a stepper that is no longer selected.
void ParameterCommand::apply(const std::vector<Setting> &settings) {
    std::vector<Setting> present;
    std::copy_if(settings.begin(), settings.end(), std::back_inserter(present),
                 [this](const Setting &setting) { return m_parameters.indexOf(setting.id) >= 0; });
    m_parameters.set(present);
}

} // namespace inspector::ui
