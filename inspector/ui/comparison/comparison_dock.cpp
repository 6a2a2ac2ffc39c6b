// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/comparison/comparison_dock.h"

#include "core/setup/tables.h"
#include "ui/comparison/deviation_text.h"
#include "ui/comparison/distance_plot.h"
#include "ui/parts/action_widgets.h"
#include "ui/parts/elided_label.h"
#include "ui/parts/flow_layout.h"
#include "ui/parts/number_box.h"
#include "ui/parts/stepper_items.h"
#include "ui/plots/plot_panel.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace inspector::ui {

namespace {
const QString kPrefix = QStringLiteral("comparison_");
}

ComparisonDock::ComparisonDock(Session &session, const Actions &actions, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_stepper(new QComboBox)
    , m_substeps(new NumberBox)
    , m_figures(new ElidedLabel)
    , m_plot(new DistancePlot(session.simulation().samples())) {
    setObjectName(QStringLiteral("comparison"));
    m_figures->setObjectName(QStringLiteral("comparison_figures"));
    m_figures->setToolTip(tr("Speed and energy: the ball's minus the ghost's"));
    auto *panel = new PlotPanel(m_plot, m_plot->time(), QStringLiteral("distance"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 2, 4, 0);
    layout->setSpacing(2);
    layout->addWidget(makeControls(actions));
    layout->addWidget(m_figures);
    layout->addWidget(panel, 1);

    connect(panel, &PlotPanel::followWanted, m_plot, &TimePlot::setFollowing);
    connect(panel, &PlotPanel::pauseWanted, m_plot, &TimePlot::setPaused);
    connect(panel, &PlotPanel::clearWanted, m_plot, &TimePlot::clear);
    connect(panel, &PlotPanel::saveWanted, this, &ComparisonDock::saveWanted);
    connect(m_stepper, &QComboBox::activated, this, &ComparisonDock::choose);
    connect(m_substeps, &NumberBox::entered, this, &ComparisonDock::chooseSubsteps);
    connect(&session.comparison(), &Comparison::changed, this, &ComparisonDock::showComparison);
    for (const auto signal : {&Session::stepperChanged, &Session::paceChanged, &Session::levelOpened})
        connect(&session, signal, this, &ComparisonDock::showComparison);
    showComparison();
}

QWidget *ComparisonDock::makeControls(const Actions &actions) {
    m_stepper->setObjectName(QStringLiteral("comparison_stepper"));
    m_stepper->setToolTip(tr("The stepper that moves the ghost"));
    m_stepper->setAccessibleName(tr("The ghost's stepper"));
    m_substeps->setAccessibleName(tr("Parts of the ball's time step"));
    m_stepper->setFocusPolicy(Qt::TabFocus);
    addStepperItems(*m_stepper, m_session.registry());
    connect(&m_session, &Session::steppersAdded, this, [this] { addStepperItems(*m_stepper, m_session.registry()); });
    m_substeps->setObjectName(QStringLiteral("comparison_substeps"));
    m_substeps->setToolTip(tr("The ghost's time step, as a part of the ball's"));
    m_substeps->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_substeps->setKind(wholeNumberKind(1, GhostChoice::kMostSubsteps));

    return flowOf({switchFor(actions.compare, kPrefix), new QLabel(tr("with")), m_stepper, new QLabel(tr("at dt /")),
                   m_substeps, buttonFor(actions.meetAgain, kPrefix), switchFor(actions.ownParameters, kPrefix)});
}

void ComparisonDock::choose() {
    m_session.comparison().setGhostChoice({m_stepper->currentData().toByteArray(), int(m_substeps->value())});
}

void ComparisonDock::chooseSubsteps(double count) {
    m_substeps->setValue(count);
    choose();
}

void ComparisonDock::showComparison() {
    const GhostChoice &ghostChoice = m_session.comparison().ghostChoice();
    if (ghostChoice != std::exchange(m_named, ghostChoice)) {
        m_isNamedAnew = true;
        m_plot->clear();
    }
    m_stepper->setCurrentIndex(m_stepper->findData(ghostChoice.stepper));
    m_substeps->setValue(ghostChoice.substeps);
    const auto name = [&](const QByteArray &id, double dt) {
        return QStringLiteral("%1, %2").arg(stepperName(m_session.registry(), id), stepSizeText(dt));
    };
    m_plot->setRadius(phys_scene_radius(m_session.scene().get()));
    m_plot->setNames(tr("Ball: %1").arg(name(m_session.stepperId(), m_session.dt())),
                     tr("Ghost: %1").arg(name(ghostChoice.stepper, m_session.dt() / ghostChoice.substeps)));
}

void ComparisonDock::refresh(const Snapshot &now) {
    if (!isVisible()) return;
    if (!m_session.isInPast()) // the past has nothing new
        m_session.liveUncertainty().follow(now, m_session.simulation().samples(), m_session.scene(),
                                           m_session.lookAhead().unknowns());
    if (visibleRegion().isEmpty()) return; // behind another dock: once it is seen
    const bool isOfLiveRun = now.history.place >= now.history.run;
    m_band = isOfLiveRun ? m_session.liveUncertainty().band() : nullptr;
    m_plot->showBand(m_band);
    m_figures->setText(summary(now));
    m_plot->setContext({nullptr, m_session.isInPast() ? std::optional(now.current.time) : std::nullopt, {}});
    hideEarlierGhosts(now);
    if (!m_plot->visibleRegion().isEmpty()) m_plot->refresh(); // behind another dock, once it is seen
}

/// The legend has one name for the ghost, so the curve begins where that ghost started at the ball.
void ComparisonDock::hideEarlierGhosts(const Snapshot &now) {
    const Comparison::Made *made = now.ghost ? m_session.comparison().made(now.ghost->number) : nullptr;
    if (!m_isNamedAnew || !made || made->ghostChoice != m_named) return;
    m_isNamedAnew = false;
    TimeView &time = m_plot->time();
    time.clearAt(std::max(time.clearedAt(), std::nextafter(now.ghost->met.time, HUGE_VAL)));
}

QString ComparisonDock::summary(const Snapshot &now) const {
    const Comparison &comparison = m_session.comparison();
    if (!comparison.isOn()) return tr("A second ball starts where the ball is, under the same tilts.");
    if (!now.ghost) return comparison.refusal();
    const Deviation &deviation = now.ghost->deviation;
    const double radius = phys_scene_radius(m_session.scene().get());
    const bool hasGhostLeft = now.ghost->current.flags & PHYS_OUT; // it stays at the exit, and so do the figures
    const double metAt = now.ghost->met.time;
    QString figures = (hasGhostLeft ? tr("When the ghost left the maze: distance %1, speed %2, energy %3")
                                    : tr("Distance %1, speed %2, energy %3"))
                          .arg(distanceText(deviation.distance, radius), speedDifferenceText(deviation.speed),
                               energyDifferenceText(deviation.energy));
    const double since = now.ghost->current.time - metAt;
    if (std::isfinite(since)) figures = tr("%1, %2 s after they met").arg(figures, QString::number(since, 'f', 2));
    if (hasGhostLeft) return figures;
    if (now.current.flags & PHYS_OUT) return tr("%1; the ball is out of the maze").arg(figures);
    if (!m_band || !std::isfinite(metAt)) return figures; // of an earlier ghost
    const double known = m_band->middleAt(now.current.time);
    return tr("%1; not known: %2").arg(figures, distanceText(known * radius, radius));
}

} // namespace inspector::ui
