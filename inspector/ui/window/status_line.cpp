// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include "core/setup/ball_place.h"
#include "core/simulation/snapshot.h"
#include "ui/parts/elided_label.h"
#include "ui/transport/transport_bar.h"

#include <QCoreApplication>
#include <QFontDatabase>
#include <QLabel>
#include <QLayout>

#include <cmath>

namespace inspector::ui {

namespace {

QString translated(const char *text) { return QCoreApplication::translate("inspector::ui::StatusLine", text); }

bool isStill(const phys_state &ball) {
    const auto isZero = [](const phys_vec3 &v) { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; };
    return isZero(ball.velocity) && isZero(ball.spin);
}

/// The flags of the state shown. Those of a state that no step made, as one that was placed by hand, say nothing.
uint64_t flagsOf(const Snapshot &snapshot, const phys_scene *scene) {
    const phys_state &ball = snapshot.current;
    if (snapshot.previous.step != ball.step) return ball.flags;
    const uint64_t others = ball.flags & ~uint64_t(PHYS_AIRBORNE | PHYS_AT_REST);
    if (!isCarried(scene, ball.position)) return others | PHYS_AIRBORNE;
    return isStill(ball) ? others | PHYS_AT_REST : others;
}

QString ballText(const Snapshot &snapshot) {
    struct Name {
        uint64_t flag;
        const char *text;
    };
    static constexpr Name names[] = {
        {PHYS_OUT, QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "out of the maze")},
        {PHYS_AIRBORNE, QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "in the air")},
        {PHYS_SLIPPING, QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "slipping")},
        {PHYS_AT_REST, QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "at rest")},
    };
    const bool isPresent = snapshot.replay.number == 0;
    if (isPresent && snapshot.current.step == 0)
        return translated(QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "about to start"));
    for (const Name &name : names)
        if (snapshot.current.flags & name.flag) return translated(name.text);
    return translated(QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "rolling"));
}

/// Avoids "-0".
QString tiltText(double tilt) {
    const double tenths = std::round(degrees(tilt) * 10.0) + 0.0;
    return QStringLiteral("%1°").arg(tenths / 10.0, 0, 'f', 1);
}

/// A distance says nothing once one of the balls falls outside.
QString ghostText(const Snapshot &snapshot) {
    if (!snapshot.ghost) return {};
    if (snapshot.ghost->current.flags & PHYS_OUT)
        return translated(QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "out of the maze"));
    if (snapshot.current.flags & PHYS_OUT)
        return translated(QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "still in the maze"));
    return translated(QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "%1 mm apart"))
        .arg(snapshot.ghost->deviation.distance * 1e3, 0, 'g', 3);
}

QString paceText(const Snapshot &snapshot) {
    const Statistics &statistics = snapshot.statistics;
    const QString asked = speedText(statistics.speedAsked);
    if (!snapshot.running) return translated(QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "paused (%1)")).arg(asked);
    return translated(QT_TRANSLATE_NOOP("inspector::ui::StatusLine", "%1 of %2"))
        .arg(QString::number(statistics.speedReached, 'f', 2), asked);
}

QString rateText(const Snapshot &snapshot) {
    const double rate = snapshot.statistics.stepsPerSecond;
    return rate < 10.0 ? QString::number(rate, 'g', 2) : QString::number(rate, 'f', 0);
}

struct Field {
    const char *name;
    const char *label;
    const char *tip;
    const char *widest;
    QString (*text)(const Snapshot &); ///< an empty text hides the field
    bool isOfClock = false;            ///< varies from run to run
};

#define FIELD_TEXT(text) QT_TRANSLATE_NOOP("inspector::ui::StatusLine", text)
const Field kFields[] = {
    {"status_ghost", FIELD_TEXT("Ghost"), FIELD_TEXT("How far the ball that is compared with is; Ctrl+5 shows more"),
     "0.00e-00 mm apart", ghostText},
    {"status_ball", FIELD_TEXT("Ball"), FIELD_TEXT("What the last step left the ball doing"), "out of the maze",
     ballText},
    {"status_tilt", FIELD_TEXT("Tilt"), FIELD_TEXT("Slope of the board along x and y"), "-00.0° -00.0°",
     [](const Snapshot &now) {
         return QStringLiteral("%1 %2").arg(tiltText(now.inputs.tilt.x), tiltText(now.inputs.tilt.y));
     }},
    {"status_time", FIELD_TEXT("Simulated"), FIELD_TEXT("Simulated time since the start"), "0000.000 s",
     [](const Snapshot &now) { return QStringLiteral("%1 s").arg(now.current.time, 0, 'f', 3); }},
    {"status_rate", FIELD_TEXT("Steps/s"), FIELD_TEXT("Steps per second of the clock, over the last half second"),
     "000000", rateText, true},
    {"status_speed", FIELD_TEXT("Speed"), FIELD_TEXT("Real-time factor: reached, and asked for"), "paused (0.0625 ×)",
     paceText},
    {"status_lost", FIELD_TEXT("Lost"), FIELD_TEXT("Time that was dropped because steps came too late, in this run"),
     "00.00 s", [](const Snapshot &now) { return QStringLiteral("%1 s").arg(now.statistics.lostTime, 0, 'f', 2); },
     true},
};
#undef FIELD_TEXT

} // namespace

StatusLine::StatusLine(QWidget *parent)
    : QStatusBar(parent) {
    setObjectName(QStringLiteral("status"));
    setSizeGripEnabled(false);
    for (const Field &field : kFields) {
        auto *label = new ElidedLabel;
        label->setObjectName(QLatin1String(field.name));
        label->setToolTip(translated(field.tip));
        label->setContentsMargins(4, 0, 4, 0);
        label->setWidest(translated(field.label) + QStringLiteral(":  ") + QString::fromUtf8(field.widest));
        addPermanentWidget(label);
        m_fields.push_back(label);
    }
}

/// Where there is no room for all fields, those of the clock are left out first. A message takes the room of the first
/// ones, so that the others stay where they are.
void StatusLine::showSnapshot(Snapshot snapshot, const phys_scene *scene) {
    snapshot.current.flags = flagsOf(snapshot, scene);
    std::vector<bool> fits(m_fields.size());
    const auto takes = [this](size_t i) { return m_fields[i]->sizeHint().width() + layout()->spacing(); };
    int rest = width();
    for (const bool isOfClock : {false, true}) {
        for (size_t i = m_fields.size(); i-- > 0;) {
            if (kFields[i].isOfClock != isOfClock) continue;
            const QString text = kFields[i].text(snapshot);
            m_fields[i]->setText(QStringLiteral("%1: %2").arg(translated(kFields[i].label), text));
            fits[i] = !text.isEmpty() && (rest -= takes(i)) >= 0;
        }
    }
    const int message = fontMetrics().horizontalAdvance(currentMessage());
    int room = width() - (message > 0 ? message + 2 * fontMetrics().height() : 0);
    for (size_t i = m_fields.size(); i-- > 0;) m_fields[i]->setVisible(fits[i] && (room -= takes(i)) >= 0);
}

void StatusLine::leaveOutClock() {
    for (size_t i = 0; i < m_fields.size(); ++i)
        if (kFields[i].isOfClock) m_fields[i]->setText(QStringLiteral("%1: –").arg(translated(kFields[i].label)));
}

} // namespace inspector::ui
