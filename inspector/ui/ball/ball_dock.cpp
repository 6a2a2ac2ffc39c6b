// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/ball/ball_dock.h"

#include "core/setup/ball_place.h"
#include "ui/ball/ball_command.h"
#include "ui/parts/number_box.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace inspector::ui {

namespace {

struct Row {
    const char *name;
    const char *label;
    const char *unit;
    double notch;
    phys_vec3 phys_state::*vector;
    double phys_vec3::*component;
};

constexpr double kMost = 1e6;
constexpr double kTouching = 1e-3; ///< radii: smaller overlaps aren't mentioned
constexpr Row kRows[] = {
    {"ball_x", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Position x"), "m", 1e-3, &phys_state::position,
     &phys_vec3::x},
    {"ball_y", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Position y"), "m", 1e-3, &phys_state::position,
     &phys_vec3::y},
    {"ball_z", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Position z"), "m", 1e-3, &phys_state::position,
     &phys_vec3::z},
    {"ball_vx", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Velocity x"), "m/s", 1e-2, &phys_state::velocity,
     &phys_vec3::x},
    {"ball_vy", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Velocity y"), "m/s", 1e-2, &phys_state::velocity,
     &phys_vec3::y},
    {"ball_vz", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Velocity z"), "m/s", 1e-2, &phys_state::velocity,
     &phys_vec3::z},
    {"ball_wx", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Spin x"), "rad/s", 1.0, &phys_state::spin, &phys_vec3::x},
    {"ball_wy", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Spin y"), "rad/s", 1.0, &phys_state::spin, &phys_vec3::y},
    {"ball_wz", QT_TRANSLATE_NOOP("inspector::ui::BallDock", "Spin z"), "rad/s", 1.0, &phys_state::spin, &phys_vec3::z},
};

} // namespace

BallDock::BallDock(Session &session, QUndoStack &undo, QWidget *parent)
    : QScrollArea(parent)
    , m_session(session)
    , m_undo(undo)
    , m_startHere(new QPushButton(tr("Start here")))
    , m_usualStart(new QPushButton(tr("Usual start")))
    , m_note(new QLabel) {
    setObjectName(QStringLiteral("ball"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus); // its controls have it
    auto *page = new QWidget;
    auto *grid = new QGridLayout(page);
    grid->setContentsMargins(8, 6, 8, 6);
    grid->setVerticalSpacing(4);
    m_note->setObjectName(QStringLiteral("ball_note"));
    m_note->setWordWrap(true);
    grid->addWidget(m_note, 0, 0, 1, 3); // first, because the last rows may be scrolled out of sight
    for (size_t i = 0; i < std::size(kRows); ++i) {
        const Row &row = kRows[i];
        auto *box = new NumberBox;
        box->setObjectName(QLatin1String(row.name));
        box->setAccessibleName(tr(row.label));
        box->setKind(numberKind({-kMost, kMost, QString::fromUtf8(row.unit)}, row.notch));
        connect(box, &NumberBox::entered, this, [this, i](double value) { enter(i, value); });
        grid->addWidget(new QLabel(tr(row.label)), int(i) + 1, 0);
        grid->addWidget(box, int(i) + 1, 1, 1, 2);
        m_boxes.push_back(box);
    }
    m_startHere->setObjectName(QStringLiteral("start_here"));
    m_startHere->setToolTip(tr("A restart brings the ball here, as it is now"));
    m_usualStart->setObjectName(QStringLiteral("usual_start"));
    m_usualStart->setToolTip(tr("A restart brings the ball to the maze's start again"));
    for (QPushButton *button : {m_startHere, m_usualStart}) button->setFocusPolicy(Qt::TabFocus);
    connect(m_startHere, &QPushButton::clicked, this,
            [this] { m_session.setStart(m_session.simulation().latest().current); });
    connect(m_usualStart, &QPushButton::clicked, this, [this] { m_session.setStart(std::nullopt); });
    const int line = int(std::size(kRows)) + 1;
    grid->addWidget(m_startHere, line, 1);
    grid->addWidget(m_usualStart, line, 2);
    grid->setRowStretch(line + 1, 1);
    setWidget(page);
}

void BallDock::enter(size_t row, double value) {
    const Snapshot before = m_session.simulation().latest();
    phys_state after = before.current;
    after.*kRows[row].vector.*kRows[row].component = value;
    m_session.placeBall(after);
    pushBallCommand(m_session, m_undo, before, after);
    m_boxes[row]->setValue(value);
}

/// Describes what is unusual about the place of a paused ball, or what can be done with it.
QString BallDock::noteOf(const phys_state &ball) const {
    const phys_scene *scene = m_session.scene().get();
    const double overlap = overlapOf(scene, ball.position);
    if (overlap > kTouching * phys_scene_radius(scene))
        return tr("It overlaps the board by %1 mm.").arg(overlap * 1e3, 0, 'g', 3);
    if (!hasFloorBelow(scene, ball.position)) return tr("There is no board below: it will fall.");
    return tr("Typed here, or dragged in the view.");
}

void BallDock::refresh(const Snapshot &now) {
    if (!isVisible()) return;
    const bool canBeSet = !now.running && !m_session.isReplaying();
    for (size_t i = 0; i < m_boxes.size(); ++i) {
        m_boxes[i]->setEnabled(canBeSet);
        m_boxes[i]->setValue(now.current.*kRows[i].vector.*kRows[i].component);
        if (!m_boxes[i]->isRefused()) m_boxes[i]->setToolTip(m_boxes[i]->exactText());
    }
    m_note->setText(canBeSet                  ? noteOf(now.current)
                    : m_session.isReplaying() ? tr("As recorded; can be set after going on from here (G).")
                                              : tr("Can be set while a game or a run is paused."));
    m_startHere->setEnabled(canBeSet);
    m_usualStart->setEnabled(m_session.start().isOwn());
}

} // namespace inspector::ui
