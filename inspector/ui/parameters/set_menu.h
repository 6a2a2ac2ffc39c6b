// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/parameter_sets.h"

#include <QMenu>

#include <functional>

class QInputDialog;
class QSettings;
class QUndoStack;

namespace inspector::ui {

enum class Owner;

/// Menu of named parameter sets, the built-in ones and the user's own, which are kept in the settings. Sets can be
/// applied, saved, deleted, imported and exported. Changes go through the undo stack.
class SetMenu : public QMenu {
    Q_OBJECT

public:
    /// parameters: the ball's, which are saved. All must outlive the menu. ghostHasOwn: tells whether the ghost has its
    /// own parameters.
    SetMenu(const Parameters &parameters, QSettings &settings, QUndoStack &undo, std::function<bool()> ghostHasOwn,
            QWidget *parent);

    /// The user's sets, by name; damaged ones are left out.
    std::vector<ParameterSet> kept() const;

signals:
    void chosen(const inspector::ParameterSet &set, Owner owner);
    void failed(const QString &line);
    void exported(const QString &path);

private:
    void renameKeys();
    QStringList keys() const; ///< of the user's sets
    void fill();
    void addSets(QMenu &menu, Owner owner);
    void addSet(QMenu &menu, Owner owner, const ParameterSet &set);
    void addDeletions(QMenu &menu);
    void askForName();
    void judgeName(QInputDialog &dialog, const QString &name) const;
    QString freeName(const QString &wanted, ParameterSet set) const;
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
