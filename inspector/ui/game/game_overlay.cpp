// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/game/game_overlay.h"

#include "ui/game/clock_text.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFontDatabase>
#include <QPainter>

#include <array>

namespace inspector::ui {

namespace {

QString say(const char *text) { return QCoreApplication::translate("inspector::ui::GameOverlay", text); }

QString winLine(const Session &session, const Game &game) {
    QString time = clockText(game.time());
    if (session.hasAutopilot())
        return say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "%1 – the autopilot's")).arg(time);
    if (game.isRecord()) return say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "%1 – a new best time")).arg(time);
    const std::optional<double> best = game.bestTime(game.level());
    if (!best) return time;
    return say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "%1 – best time %2")).arg(time, clockText(*best));
}

QFont scaled(QFont font, double factor, bool isBold) {
    font.setPointSizeF(font.pointSizeF() * factor);
    font.setBold(isBold);
    return font;
}

} // namespace

QString levelTitle(const Session &session) {
    const std::vector<Level> &levels = session.levels();
    for (size_t index = 0; index < levels.size(); ++index)
        if (levels[index].path == session.level().path)
            return say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "Level %1")).arg(index + 1);
    return session.level().name;
}

OverlayText overlayText(Session &session, const Snapshot &now) {
    const Game &game = session.game();
    const QString title = levelTitle(session);
    OverlayText text;
    if (session.isReplaying()) {
        text.clock = clockText(now.current.time);
        return text;
    }
    switch (game.phase()) {
    case Game::Phase::Prompt:
        // Whoever just lets the ball roll, without the game, needs no prompt.
        if (now.running || now.current.step > 0) break;
        text.title = title;
        text.line = say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "Press Enter to start"));
        text.hint =
            session.hasAutopilot()
                ? say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "The autopilot plays · A takes over"))
                : say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "Arrow keys tilt the board · roll the ball out"));
        break;
    case Game::Phase::Playing:
        text.clock = clockText(now.current.time);
        // Whoever watches the autopilot pauses to look: no card then.
        if (now.running || now.current.step == 0 || session.hasAutopilot()) break;
        text.title = say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "Paused"));
        text.line = say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "Space goes on"));
        text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "R restarts the level"));
        break;
    case Game::Phase::Won:
        text.title = say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "%1 done")).arg(title);
        text.line = winLine(session, game);
        text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameOverlay", "Enter: level %1 · R: again"))
                        .arg((game.level() + 1) % int(std::max<size_t>(1, session.levels().size())) + 1);
        break;
    }
    return text;
}

GameOverlay::GameOverlay(QWidget *parent)
    : QWidget(parent) {
    setObjectName(QStringLiteral("game_overlay"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setGeometry(parent->rect());
    parent->installEventFilter(this);
}

bool GameOverlay::eventFilter(QObject *object, QEvent *event) {
    if (event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(object, event);
}

void GameOverlay::setText(const OverlayText &text) {
    if (text == m_text) return;
    m_text = text;
    update();
}

void GameOverlay::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_text.clock.isEmpty()) paintClock(painter);
    if (!m_text.title.isEmpty()) paintCard(painter);
}

void GameOverlay::paintPlate(QPainter &painter, const QRectF &rect) const {
    QColor plate = palette().color(QPalette::Window);
    plate.setAlphaF(0.86F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(plate);
    painter.drawRoundedRect(rect, 10.0, 10.0);
    painter.setPen(palette().color(QPalette::WindowText));
}

void GameOverlay::paintClock(QPainter &painter) const {
    const QFont font = scaled(QFontDatabase::systemFont(QFontDatabase::FixedFont), 1.6, true);
    const QFontMetricsF metrics(font);
    const QSizeF size(metrics.horizontalAdvance(m_text.clock) + 28.0, metrics.height() + 10.0);
    const QRectF plate(QPointF(12.0, 12.0), size); // the far edge of the board is shorter, so that corner is free
    paintPlate(painter, plate);
    painter.setFont(font);
    painter.drawText(plate, Qt::AlignCenter, m_text.clock);
}

void GameOverlay::paintCard(QPainter &painter) const {
    struct Line {
        QString text;
        QFont font;
    };
    const std::array lines{Line{m_text.title, scaled(font(), 1.5, true)}, Line{m_text.line, scaled(font(), 1.9, false)},
                           Line{m_text.hint, font()}};
    constexpr double kGap = 8.0;
    constexpr double kBorder = 22.0;
    QSizeF size(0.0, -kGap);
    for (const Line &line : lines) {
        const QFontMetricsF metrics(line.font);
        size = {std::max(size.width(), metrics.horizontalAdvance(line.text)), size.height() + metrics.height() + kGap};
    }
    const QRectF text((width() - size.width()) / 2.0, (height() - size.height()) / 2.0, size.width(), size.height());
    paintPlate(painter, text.adjusted(-1.6 * kBorder, -kBorder, 1.6 * kBorder, kBorder));
    double top = text.top();
    for (const Line &line : lines) {
        const double height = QFontMetricsF(line.font).height();
        painter.setFont(line.font);
        painter.drawText(QRectF(text.left(), top, text.width(), height), Qt::AlignCenter, line.text);
        top += height + kGap;
    }
}

} // namespace inspector::ui
