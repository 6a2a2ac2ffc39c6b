// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/parameter_sets.h"

#include <QMenu>

#include <functional>

class QSettings;
class QUndoStack;

namespace inspector::ui {

enum class Owner;

// Named sets of parameters: the known ones and those that a person keeps in the settings; to be used, saved, deleted,
// imported and exported. What it changes goes through the undo stack.
class SetMenu : public QMenu {
    Q_OBJECT

public:
    // parameters: the ball's, which are saved. All outlive the menu. asked: whether the ghost has own ones.
    SetMenu(const Parameters &parameters, QSettings &settings, QUndoStack &undo, std::function<bool()> ghostHasOwn,
            QWidget *parent);

    // By name; damaged ones are left out.
    std::vector<ParameterSet> kept() const;

signals:
    void chosen(const inspector::ParameterSet &set, Owner owner);
    void failed(const QString &line);

private:
    void fill();
    void addSets(QMenu &menu, Owner owner);
    void addSet(QMenu &menu, Owner owner, const ParameterSet &set);
    void addDeletions(QMenu &menu);
    void askForName();
    void keep(const ParameterSet &set, const QString &text);
    void remove(const ParameterSet &set);
    void askWhatToImport();
    void import(const QString &path);
    void askWhereToExport();
    void exportTo(const QString &path);

    const Parameters &m_parameters;
    QSettings &m_settings;
    QUndoStack &m_undo;
    std::function<bool()> m_ghostHasOwn;
};

} // namespace inspector::ui
