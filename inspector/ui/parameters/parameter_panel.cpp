// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/parameter_panel.h"

#include "ui/parameters/parameter_command.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/set_menu.h"
#include "ui/parts/action_widgets.h"
#include "ui/parts/described.h"
#include "ui/parts/flow_layout.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>
#include <QUndoStack>

#include <cmath>
#include <utility>

namespace inspector::ui {

namespace {

/// Colours of rows that can't be edited at the moment: fainter than editable ones, stronger than ones without effect,
/// and no button stands out of the window.
QPalette readable(const QPalette &palette) {
    QPalette result;
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor colour = palette.color(QPalette::Active, role);
        colour.setAlphaF(0.75F);
        result.setColor(QPalette::Disabled, role, colour);
    }
    constexpr int kFlat = 107; // per cent, by which styles lighten the face of a button
    result.setColor(QPalette::Disabled, QPalette::Button, palette.color(QPalette::Window).darker(kFlat));
    return result;
}

} // namespace

ParameterPanel::ParameterPanel(Session &session, QUndoStack &undo, const Actions &actions, QWidget *parent)
    : QScrollArea(parent)
    , m_session(session)
    , m_undo(undo)
    , m_actions(actions)
    , m_ball{Owner::Ball, session.parameters()}
    , m_ghost{Owner::Ghost, session.comparison().parameters()}
    , m_sets(new SetMenu(
          m_ball.parameters, session.settings(), undo,
          [this] { return m_session.comparison().isOn() && m_session.comparison().hasOwnParameters(); }, this)) {
    setObjectName(QStringLiteral("parameters"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (Side *side : {&m_ball, &m_ghost}) {
        connect(&side->parameters, &Parameters::changed, this,
                [this, side](int index, double value) { showValue(*side, index, value); });
        connect(&side->parameters, &Parameters::rowsChanged, this, &ParameterPanel::rebuild);
    }
    connect(&m_session, &Session::autopilotChanged, this, &ParameterPanel::showPilot);
    connect(&m_session, &Session::levelOpened, this, &ParameterPanel::takeBack);
    connect(&m_session, &Session::trackChanged, this, &ParameterPanel::showPilot);
    connect(&m_session, &Session::replayChanged, this, &ParameterPanel::updateLocks);
    connect(&m_session.comparison(), &Comparison::changed, this, &ParameterPanel::showGhost);
    connect(m_sets, &SetMenu::chosen, this,
            [this](const ParameterSet &set, Owner owner) { useSet(owner == Owner::Ball ? m_ball : m_ghost, set); });
    connect(m_sets, &SetMenu::failed, this, &ParameterPanel::refused);
    connect(m_sets, &SetMenu::exported, this, &ParameterPanel::saved);
    rebuild();
}

QSize ParameterPanel::sizeHint() const {
    return widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 2 * frameWidth());
}

void ParameterPanel::changeEvent(QEvent *event) {
    QScrollArea::changeEvent(event);
    // The rows take the font later.
    if (event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &ParameterPanel::fitWidth, Qt::QueuedConnection);
    if (event->type() != QEvent::PaletteChange || m_ball.rows.empty()) return;
    updateLocks(); // the theme may have changed
    for (ParameterRow *row : m_ghost.rows)
        if (row) row->takeColours();
}

/// The ghost's row of a parameter follows the ball's row; rows that only the ghost's stepper has come last.
void ParameterPanel::rebuild() {
    auto *page = new QWidget;
    auto *grid = new QGridLayout(page);
    grid->setContentsMargins(6, 6, 4, 6);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 3);
    grid->setColumnStretch(2, 1);
    m_ball.rows.clear();
    m_ghost.rows.assign(size_t(m_ghost.parameters.count()), nullptr);
    grid->addWidget(makeHead(), 0, 0, 1, 4);
    int line = 1;
    for (int index = 0; index < m_ball.parameters.count(); ++index) {
        m_ball.rows.push_back(nullptr);
        addRow(m_ball, index, *grid, line++);
        const int ghosts = m_ghost.parameters.indexOf(QString::fromUtf8(m_ball.parameters.row(index).id));
        if (ghosts >= 0 && !isTilt(m_ghost.parameters.row(ghosts))) addRow(m_ghost, ghosts, *grid, line++);
    }
    for (int index = 0; index < m_ghost.parameters.count(); ++index) {
        const phys_param_row &row = m_ghost.parameters.row(index);
        if (!m_ghost.rows[size_t(index)] && !isTilt(row)) addRow(m_ghost, index, *grid, line++);
    }
    addResetAll(*grid, line);
    setWidget(page); // deletes the previous page
    fitWidth();
    showGhost();
}

void ParameterPanel::fitWidth() {
    setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
}

void ParameterPanel::addRow(Side &side, int index, QGridLayout &grid, int line) {
    const phys_param_row &what = side.parameters.row(index);
    const bool isBeside = m_ball.parameters.indexOf(QString::fromUtf8(what.id)) >= 0;
    auto *row = new ParameterRow(what, {side.owner, isBeside}, grid, line, grid.parentWidget());
    connect(row, &ParameterRow::edited, this, [this, &side, index](double value) { edit(side, index, value); });
    connect(row, &ParameterRow::gestureBegun, this, [this] { ++m_gesture; });
    row->showValue(side.parameters.value(index));
    side.rows[size_t(index)] = row;
}

QWidget *ParameterPanel::makeHead() {
    const QString prefix = QStringLiteral("parameters_");
    auto *sets = new QPushButton(tr("Sets"));
    sets->setObjectName(QStringLiteral("parameter_sets"));
    describe(sets, tr("Named sets of parameters"), tr("Parameters by name: materials, and what you saved"));
    sets->setMenu(m_sets);
    sets->setFocusPolicy(Qt::TabFocus);
    QCheckBox *ghostsOwn = switchFor(m_actions.ghostsOwn, prefix);
    ghostsOwn->setAccessibleName(ghostsOwn->text());
    ghostsOwn->setText(tr("Ghost's own")); // parameters: the dock says so
    QWidget *head = flowOf({sets, ghostsOwn, buttonFor(m_actions.copy, prefix), buttonFor(m_actions.swap, prefix)});
    head->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // in two lines where the rows are narrower
    return head;
}

void ParameterPanel::addResetAll(QGridLayout &grid, int line) {
    m_resetAll = new QPushButton(tr("Reset all"));
    m_resetAll->setObjectName(QStringLiteral("reset_all"));
    m_resetAll->setToolTip(tr("Every parameter of the ball back to its default"));
    m_resetAll->setFocusPolicy(Qt::TabFocus);
    connect(m_resetAll, &QPushButton::clicked, this, &ParameterPanel::resetAll);
    grid.addWidget(m_resetAll, line, 2, 1, 2, Qt::AlignRight);
    grid.setRowStretch(line + 1, 1);
}

void ParameterPanel::edit(Side &side, int index, double value) {
    const double before = side.parameters.value(index);
    QString error;
    if (!side.parameters.set(index, value, &error)) {
        side.rows[size_t(index)]->showValue(before);
        if (!side.rows[size_t(index)]->refuse(error)) emit refused(error);
        return;
    }
    const phys_param_row &row = side.parameters.row(index);
    const QString id = QString::fromUtf8(row.id);
    if (before == value) return;
    const QString label = QString::fromUtf8(row.label);
    const QString text =
        side.owner == Owner::Ghost ? tr("change of the ghost's %1").arg(label) : tr("change of %1").arg(label);
    m_undo.push(new ParameterCommand(side.parameters, {{id, before}}, {{id, value}}, m_gesture, text));
}

/// Sets several rows as one undo step.
void ParameterPanel::change(Side &side, const std::vector<Setting> &wanted, const QString &text) {
    std::vector<Setting> before;
    before.reserve(wanted.size());
    for (const Setting &setting : wanted)
        before.push_back({setting.id, side.parameters.value(side.parameters.indexOf(setting.id))});
    QString error;
    if (!side.parameters.set(wanted, &error)) return emit refused(error);
    for (const Setting &setting : wanted) // also where the value is the same
        if (ParameterRow *row = side.rows[size_t(side.parameters.indexOf(setting.id))]) row->takeBack();
    if (before != wanted) m_undo.push(new ParameterCommand(side.parameters, before, wanted, ++m_gesture, text));
}

void ParameterPanel::resetAll() {
    std::vector<Setting> initial;
    for (int index = 0; index < m_ball.parameters.count(); ++index) {
        const phys_param_row &row = m_ball.parameters.row(index);
        initial.push_back({QString::fromUtf8(row.id), row.initial});
    }
    change(m_ball, initial, tr("reset of all parameters"));
}

/// Shows every value instead of invalid input.
void ParameterPanel::takeBack() {
    for (const Side *side : {&m_ball, &m_ghost})
        for (ParameterRow *row : side->rows)
            if (row) row->takeBack();
}

/// A recorded ball's values can't be edited.
void ParameterPanel::useSet(Side &side, const ParameterSet &set) {
    if (side.owner == Owner::Ball && m_session.isReplaying())
        return emit refused(tr("a recording is shown as it was; Go on from here makes its parameters yours to change"));
    change(side, valuesFor(side.parameters, set), tr("parameters of %1").arg(set.name));
}

void ParameterPanel::copyToGhost() {
    change(m_ghost, sharedValues(m_ball.parameters, m_ghost.parameters), tr("copy to the ghost"));
}

void ParameterPanel::swapWithGhost() {
    const std::vector<Setting> balls = sharedValues(m_ball.parameters, m_ghost.parameters);
    const std::vector<Setting> ghosts = sharedValues(m_ghost.parameters, m_ball.parameters);
    QString error;
    if (!m_ball.parameters.set(ghosts, &error)) return emit refused(error);
    if (!m_ghost.parameters.set(balls, &error)) {
        m_ball.parameters.set(balls);
        return emit refused(error);
    }
    if (balls == ghosts) return;
    ++m_gesture;
    m_undo.beginMacro(tr("swap with the ghost"));
    m_undo.push(new ParameterCommand(m_ball.parameters, balls, ghosts, m_gesture, {}));
    m_undo.push(new ParameterCommand(m_ghost.parameters, ghosts, balls, m_gesture, {}));
    m_undo.endMacro();
}

void ParameterPanel::showValue(const Side &side, int index, double value) {
    const phys_param_row &row = side.parameters.row(index);
    ParameterRow *shown = side.rows[size_t(index)];
    if (!shown) return;
    // A tilt set by keys, live or recorded, has angles with any number of digits.
    const bool isShown = m_session.isTiltedByKeys() || m_session.isReplaying() || m_session.isInPast();
    const bool isPassing = isTilt(row) && isShown;
    shown->showValue(isPassing ? std::round(value / row.step) * row.step : value);
    if (row.flags & PHYS_ROW_CHOICE) updateLocks(); // the model may have changed
}

void ParameterPanel::showPilotsTilt(Tilt tilt) {
    const std::pair<const char *, double> tilts[] = {{"tilt_x", tilt.x}, {"tilt_y", tilt.y}};
    for (const auto &[id, angle] : tilts) {
        const int index = m_ball.parameters.indexOf(QLatin1String(id));
        m_ball.rows[size_t(index)]->showValue(std::round(degrees(angle) * 10.0) / 10.0);
    }
}

/// The sliders show the parameters again when nothing else sets the tilt.
void ParameterPanel::showPilot() {
    for (int index = 0; index < m_ball.parameters.count(); ++index)
        m_ball.rows[size_t(index)]->showValue(m_ball.parameters.value(index));
    updateLocks();
}

void ParameterPanel::showGhost() {
    const Comparison &comparison = m_session.comparison();
    for (int index = 0; index < m_ghost.parameters.count(); ++index) {
        ParameterRow *row = m_ghost.rows[size_t(index)];
        if (!row) continue;
        row->setVisible(comparison.isOn() && comparison.hasOwnParameters());
        row->showValue(m_ghost.parameters.value(index));
    }
    updateLocks();
}

void ParameterPanel::updateLocks() {
    for (const Side *side : {&m_ball, &m_ghost})
        for (int index = 0; index < side->parameters.count(); ++index)
            if (ParameterRow *row = side->rows[size_t(index)])
                row->setLocked(lockOf(*side, side->parameters.row(index)));
    for (ParameterRow *row : m_ball.rows) row->setPalette(m_session.isReplaying() ? readable(palette()) : QPalette());
    m_resetAll->setEnabled(!m_session.isReplaying());
}

QString ParameterPanel::lockOf(const Side &side, const phys_param_row &row) const {
    if (m_session.isReplaying() && side.owner == Owner::Ball)
        return tr("As recorded; Go on from here makes it yours to change.");
    if ((row.flags & PHYS_ROW_RIGID) && side.parameters.inputs().params.model != PHYS_MODEL_RIGID)
        return tr("Acts in the rigid model only; choose it under Model.");
    if (isTilt(row) && m_session.hasAutopilot()) return tr("The autopilot tilts the board; A switches it off.");
    if (isTilt(row) && m_session.isFollowingTrack())
        return tr("The board is tilted as the measured ball's was; Roll along switches that off, and so does an arrow "
                  "key.");
    return {};
}

} // namespace inspector::ui
