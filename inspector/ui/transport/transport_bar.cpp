// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/transport/transport_bar.h"

#include "ui/parts/number_box.h"
#include "ui/parts/stepper_items.h"
#include "ui/parts/stepping_command.h"

#include <QComboBox>
#include <QLabel>

#include <cmath>

namespace inspector::ui {

namespace {

constexpr double kSpeeds[] = {1.0 / 16.0, 1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0, 1.0, 2.0, 4.0, 8.0, 16.0};

} // namespace

QString speedText(double speed) {
    const double divisor = 1.0 / speed;
    const bool isFraction = divisor > 1.0 && divisor == std::round(divisor);
    return isFraction ? QStringLiteral("1/%1 ×").arg(divisor) : QStringLiteral("%1 ×").arg(speed);
}

TransportBar::TransportBar(Session &session, QUndoStack &undo, const QList<QAction *> &playback, QWidget *parent)
    : QToolBar(tr("Toolbar"), parent)
    , m_session(session)
    , m_undo(undo) {
    setObjectName(QStringLiteral("transport"));
    addActions(playback);
    addSpeeds();
    addSteppers();
    addTimeSteps();
    connect(&session, &Session::paceChanged, this, &TransportBar::showPace);
    connect(&session, &Session::stepperChanged, this, &TransportBar::showStepper);
    connect(&session, &Session::replayChanged, m_stepper, &QWidget::setDisabled);
    connect(&session, &Session::replayChanged, m_timeStep, &QWidget::setDisabled);
    m_stepper->setDisabled(session.isReplaying());
    m_timeStep->setDisabled(session.isReplaying());
    showPace();
    showStepper();
    fitStepper();
}

QComboBox *TransportBar::addChooser(const QString &label, const char *name, const QString &tip) {
    addSeparator();
    auto *text = new QLabel(label);
    text->setContentsMargins(6, 0, 6, 0);
    auto *chooser = new QComboBox;
    chooser->setObjectName(QLatin1String(name));
    chooser->setToolTip(tip);
    chooser->setAccessibleName(label);
    chooser->setAccessibleDescription(tip);
    chooser->setFocusPolicy(Qt::TabFocus);
    chooser->setSizeAdjustPolicy(QComboBox::AdjustToContents); // not only to those of its first show
    addWidget(text);
    addWidget(chooser);
    return chooser;
}

void TransportBar::addSpeeds() {
    m_speed = addChooser(tr("Speed"), "speed",
                         tr("Simulated seconds per second. It changes how many steps are made, never dt."));
    for (const double speed : kSpeeds) m_speed->addItem(speedText(speed), speed);
    connect(m_speed, &QComboBox::activated, this, [this](int index) {
        m_session.setSpeed(m_speed->itemData(index).toDouble());
        showPace();
    });
}

void TransportBar::addSteppers() {
    m_stepper = addChooser(tr("Stepper"), "stepper", tr("How a step is computed."));
    addStepperItems(*m_stepper, m_session.registry());
    connect(&m_session, &Session::steppersAdded, this, [this] {
        addStepperItems(*m_stepper, m_session.registry());
        fitStepper();
    });
    connect(m_stepper, &QComboBox::activated, this, [this](int index) {
        const Stepping wanted{m_stepper->itemData(index).toByteArray(), m_session.dt(), {}};
        changeStepping(m_session, m_undo, wanted, tr("choice of %1").arg(m_stepper->itemText(index)));
        showStepper(); // also after a refusal
    });
}

void TransportBar::addTimeSteps() {
    m_timeStep =
        addChooser(tr("Time step"), "time_step",
                   tr("Simulated time of one step; choose one or type your own: 5 ms, 20 us, 1/60. A number without a "
                      "unit is in s, as for --dt."));
    for (const double dt : usualStepSizes()) m_timeStep->addItem(durationText(dt), dt);
    m_typedTimeStep = new NumberBox;
    m_typedTimeStep->setObjectName(QStringLiteral("time_step_box"));
    m_typedTimeStep->setAccessibleName(tr("Time step"));
    m_typedTimeStep->setToolTip(m_timeStep->toolTip());
    m_typedTimeStep->setKind(durationKind(Engine::kSmallestDt, Engine::kLargestDt));
    m_typedTimeStep->setAlignment(Qt::AlignLeft);
    m_timeStep->setEditable(true);
    m_timeStep->setLineEdit(m_typedTimeStep);
    m_timeStep->setInsertPolicy(QComboBox::NoInsert);
    m_timeStep->setCompleter(nullptr); // "1" is 1 ms and not the beginning of 10 ms
    m_timeStep->setFocusPolicy(Qt::StrongFocus);
    m_timeStep->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_timeStep->setMinimumContentsLength(9);
    m_timeStep->setMinimumWidth(m_timeStep->minimumSizeHint().width() / 2);
    connect(m_timeStep, &QComboBox::activated, this,
            [this](int index) { changeTimeStep(m_timeStep->itemData(index).toDouble()); });
    connect(m_typedTimeStep, &NumberBox::entered, this, &TransportBar::changeTimeStep);
}

void TransportBar::changeTimeStep(double dt) {
    Stepping wanted = m_session.stepping();
    wanted.dt = dt;
    changeStepping(m_session, m_undo, wanted, tr("change of Time step"));
    showPace(); // also after a refusal
}

/// The command line knows speeds between the usual ones.
void TransportBar::showSpeed() {
    const double speed = m_session.speed();
    int place = 0;
    while (place < m_speed->count() && m_speed->itemData(place).toDouble() < speed) ++place;
    if (m_speed->itemData(place) != speed) m_speed->insertItem(place, speedText(speed), speed);
    m_speed->setMaxVisibleItems(m_speed->count());
    m_speed->setCurrentIndex(place);
}

void TransportBar::showPace() {
    showSpeed();
    m_timeStep->setCurrentIndex(m_timeStep->findData(m_session.dt()));
    m_typedTimeStep->setValue(m_session.dt());
}

/// A bar that is too short takes room from the other choosers: a stepper's name says more than its beginning.
void TransportBar::fitStepper() { m_stepper->setMinimumWidth(m_stepper->sizeHint().width()); }

void TransportBar::changeEvent(QEvent *event) {
    QToolBar::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &TransportBar::fitStepper, Qt::QueuedConnection);
}

void TransportBar::showStepper() { m_stepper->setCurrentIndex(m_stepper->findData(m_session.stepperId())); }

} // namespace inspector::ui
