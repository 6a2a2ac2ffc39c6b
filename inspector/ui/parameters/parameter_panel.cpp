// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/parameter_panel.h"

#include "ui/parameters/parameter_command.h"
#include "ui/parameters/parameter_row.h"

#include <QEvent>
#include <QGridLayout>
#include <QPushButton>
#include <QScrollBar>
#include <QUndoStack>

#include <cmath>
#include <utility>

namespace inspector::ui {

namespace {
bool isTilt(const phys_param_row &row) {
    const QLatin1String id(row.id);
    return id == QLatin1String("tilt_x") || id == QLatin1String("tilt_y");
}

// What can't be changed just now but is there to be read: fainter than what can, stronger than what has no effect.
QPalette readable(const QPalette &palette) {
    QPalette result;
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor colour = palette.color(QPalette::Active, role);
        colour.setAlphaF(0.75F);
        result.setColor(QPalette::Disabled, role, colour);
    }
    return result;
}

} // namespace

ParameterPanel::ParameterPanel(Session &session, QUndoStack &undo, QWidget *parent)
    : QScrollArea(parent)
    , m_session(session)
    , m_parameters(session.parameters())
    , m_undo(undo) {
    setObjectName(QStringLiteral("parameters"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(&m_parameters, &Parameters::changed, this, &ParameterPanel::showValue);
    connect(&m_parameters, &Parameters::rowsChanged, this, &ParameterPanel::rebuild);
    connect(&m_session, &Session::autopilotChanged, this, &ParameterPanel::showAutopilot);
    connect(&m_session, &Session::replayChanged, this, &ParameterPanel::updateLocks);
    rebuild();
}

QSize ParameterPanel::sizeHint() const {
    return widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 2 * frameWidth());
}

void ParameterPanel::changeEvent(QEvent *event) {
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !m_rows.empty()) updateLocks(); // another theme
}

void ParameterPanel::rebuild() {
    auto *page = new QWidget;
    auto *grid = new QGridLayout(page);
    grid->setContentsMargins(8, 6, 8, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    m_rows.clear();
    for (int index = 0; index < m_parameters.count(); ++index) {
        auto *row = new ParameterRow(m_parameters.row(index), *grid, index, page);
        connect(row, &ParameterRow::edited, this, [this, index](double value) { edit(index, value); });
        connect(row, &ParameterRow::gestureBegun, this, [this] { ++m_gesture; });
        row->showValue(m_parameters.value(index));
        m_rows.push_back(row);
    }
    auto *resetAll = new QPushButton(tr("Reset all"));
    resetAll->setObjectName(QStringLiteral("reset_all"));
    resetAll->setToolTip(tr("Every parameter back to its default"));
    resetAll->setFocusPolicy(Qt::TabFocus);
    connect(resetAll, &QPushButton::clicked, this, &ParameterPanel::resetAll);
    grid->addWidget(resetAll, m_parameters.count(), 2, 1, 2, Qt::AlignRight);
    grid->setRowStretch(m_parameters.count() + 1, 1);
    setWidget(page); // deletes the page before it
    setMinimumWidth(page->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
    updateLocks();
}

void ParameterPanel::edit(int index, double value) {
    const double before = m_parameters.value(index);
    QString error;
    if (!m_parameters.set(index, value, &error)) {
        m_rows[size_t(index)]->showValue(before);
        if (!m_rows[size_t(index)]->refuse(error)) emit refused(error);
        return;
    }
    const phys_param_row &row = m_parameters.row(index);
    const QString id = QString::fromUtf8(row.id);
    if (before == value) return;
    m_undo.push(new ParameterCommand(m_parameters, {{id, before}}, {{id, value}}, m_gesture,
                                     tr("change of %1").arg(QString::fromUtf8(row.label))));
}

void ParameterPanel::resetAll() {
    std::vector<Setting> before;
    std::vector<Setting> after;
    for (int index = 0; index < m_parameters.count(); ++index) {
        if (m_parameters.isInitial(index)) continue;
        const phys_param_row &row = m_parameters.row(index);
        before.push_back({QString::fromUtf8(row.id), m_parameters.value(index)});
        after.push_back({QString::fromUtf8(row.id), row.initial});
    }
    if (before.empty()) return;
    m_parameters.resetAll();
    m_undo.push(new ParameterCommand(m_parameters, before, after, ++m_gesture, tr("reset of all parameters")));
}

void ParameterPanel::showValue(int index, double value) {
    const phys_param_row &row = m_parameters.row(index);
    // The spring behind the keys passes through angles of any number of digits, live or recorded.
    const bool isShown = m_session.isTiltedByKeys() || m_session.isReplaying() || m_session.isInPast();
    const bool isPassing = isTilt(row) && isShown;
    m_rows[size_t(index)]->showValue(isPassing ? std::round(value / row.step) * row.step : value);
    if (row.flags & PHYS_ROW_CHOICE) updateLocks(); // the model may be another one
}

void ParameterPanel::showFlownTilt(Tilt tilt) {
    const std::pair<const char *, double> tilts[] = {{"tilt_x", tilt.x}, {"tilt_y", tilt.y}};
    for (const auto &[id, angle] : tilts) {
        const int index = m_parameters.indexOf(QLatin1String(id));
        m_rows[size_t(index)]->showValue(std::round(degrees(angle) * 10.0) / 10.0);
    }
}

// The sliders show the parameters again when nobody flies any more.
void ParameterPanel::showAutopilot() {
    for (int index = 0; index < m_parameters.count(); ++index)
        m_rows[size_t(index)]->showValue(m_parameters.value(index));
    updateLocks();
}

void ParameterPanel::updateLocks() {
    for (int index = 0; index < m_parameters.count(); ++index)
        m_rows[size_t(index)]->setLocked(lockOf(m_parameters.row(index)));
    widget()->setPalette(m_session.isReplaying() ? readable(palette()) : QPalette());
    widget()->findChild<QPushButton *>(QStringLiteral("reset_all"))->setEnabled(!m_session.isReplaying());
}

QString ParameterPanel::lockOf(const phys_param_row &row) const {
    if (m_session.isReplaying()) return tr("As recorded; Go on from here makes it yours to change.");
    if ((row.flags & PHYS_ROW_RIGID) && m_parameters.inputs().params.model != PHYS_MODEL_RIGID)
        return tr("Acts in the rigid model only; choose it under Model.");
    if (isTilt(row) && m_session.hasAutopilot()) return tr("The autopilot tilts the board; A switches it off.");
    return {};
}

} // namespace inspector::ui
