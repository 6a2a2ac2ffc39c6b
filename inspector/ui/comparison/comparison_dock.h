// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QWidget>

class QAction;
class QComboBox;

namespace inspector::ui {

class DistancePlot;
class ElidedLabel;
class NumberBox;
class PlotPanel;

/// The comparison with a ghost: its stepper, and the distance between both balls, now and over time.
class ComparisonDock : public QWidget {
    Q_OBJECT

public:
    struct Actions {
        QAction &compare; ///< checkable
        QAction &meetAgain;
        QAction &ownParameters; ///< checkable
    };

    /// session and actions must outlive the dock.
    ComparisonDock(Session &session, const Actions &actions, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {700, 300}; }
    DistancePlot &plot() { return *m_plot; }
    /// Called about 30 times a second.
    void refresh(const Snapshot &now);

signals:
    void saveWanted();

private:
    QWidget *makeControls(const Actions &actions);
    void choose(); ///< applies the controls
    void chooseSubsteps(double count);
    void showComparison(); ///< shows the session's state
    void hideEarlierGhosts(const Snapshot &now);
    QString summary(const Snapshot &now) const;

    Session &m_session;
    QComboBox *m_stepper;
    NumberBox *m_substeps;
    ElidedLabel *m_figures;
    DistancePlot *m_plot;
    GhostChoice m_named;                ///< the choice that the legend names
    bool m_isNamedAnew = false;         ///< the plot may still show steps of an earlier choice
    std::shared_ptr<const Band> m_band; ///< uncertainty band; or null
};

} // namespace inspector::ui
