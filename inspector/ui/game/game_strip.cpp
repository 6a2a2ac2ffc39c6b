// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/game/game_strip.h"

#include "core/setup/lines.h"
#include "ui/game/clock_text.h"
#include "ui/parts/elided_label.h"
#include "ui/parts/flow_layout.h"
#include "ui/parts/path_icon.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QToolButton>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace inspector::ui {

namespace {

constexpr double kLongWait = 1.0; ///< s between two steps

QString say(const char *text) { return QCoreApplication::translate("inspector::ui::GameStrip", text); }

/// The clock beside it has the time.
QString winLine(Session &session, const Game &game) {
    const QString obstacle = session.whyNoBestTime();
    if (!obstacle.isEmpty())
        return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "no best time: %1")).arg(obstacle);
    if (game.isRecord() && !game.isStored())
        return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "a new best time, which can't be stored"));
    if (game.isRecord()) return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "a new best time"));
    const std::optional<double> best = game.bestTime();
    if (!best) return {};
    return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "best time %1")).arg(clockText(*best));
}

QString lossLine(const Session &session) {
    const QString fault = session.start().fault(session.scene());
    return fault.isEmpty() ? say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "the ball fell through a hole")) : fault;
}

/// A hint what to do; for the user's own maze also its best time, which the list of levels doesn't show.
QString promptHint(Session &session) {
    if (QString fault = session.start().fault(session.scene()); !fault.isEmpty()) return fault;
    if (session.hasAutopilot())
        return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "The autopilot plays · A takes over"));
    QString play = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip",
                                         "Arrow keys tilt the board · roll the ball out · Space: free run"));
    if (session.levels().isOpenListed()) return play;
    if (session.levels().exits() && session.levels().exits()->empty())
        return say(
            QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Arrow keys tilt the board · this maze has no way out"));
    const std::optional<double> best = session.game().bestTime();
    return best ? say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "%1 · best time %2")).arg(play, clockText(*best))
                : play;
}

/// What sets the tilt of the board.
QString tiltHint(const Session &session) {
    if (session.hasAutopilot())
        return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "The autopilot tilts the board · A takes over"));
    if (session.isFollowingTrack())
        return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Under the tilts of the measured ball"));
    return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Arrow keys or sliders tilt the board"));
}

/// The text for a run without the game.
GameText freeRunText(const Session &session, const QString &title, const Snapshot &now) {
    GameText text;
    text.title = title;
    text.line = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Free run"));
    text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "%1 · Enter: play")).arg(tiltHint(session));
    if (now.running) return text;
    text.title = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Paused"));
    text.line = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Space goes on"));
    text.hint =
        session.isBallPut()
            ? say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "R: back to the start · Enter: play from here"))
            : say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "R: back to the start · Enter: play from there"));
    if (!session.departure(now)) return text;
    text.title = title; // the status line says where the ball is
    text.line = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "The free run has ended"));
    text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "R: back to the start · Enter: play"));
    return text;
}

/// Shown while steps are so far apart that the window seems to have stopped.
QString waitHint(const Snapshot &now) {
    const double period = std::chrono::duration<double>(now.interval).count();
    if (period < kLongWait) return {};
    const double rest = std::chrono::duration<double>(now.due + now.interval - Clock::now()).count();
    return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "One step of dt takes %1 s · the next one in %2 s"))
        .arg(period, 0, 'g', 3)
        .arg(std::max(0.0, std::ceil(rest)));
}

QFont scaled(QFont font, double factor, bool isBold) {
    font.setPointSizeF(font.pointSizeF() * factor);
    font.setBold(isBold);
    return font;
}

} // namespace

QString levelTitle(const Session &session, const Level &level) {
    const std::vector<Level> &levels = session.levels().listed();
    const std::optional<int> number = numberOf(level);
    const bool isListed = std::ranges::count(levels, level.path, &Level::path) > 0;
    if (!number || !isListed) return oneLine(level.name);
    return say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Level %1")).arg(*number);
}

namespace {

GameText stateText(Session &session, const Snapshot &now) {
    const Game &game = session.game();
    const QString title = levelTitle(session, session.level());
    GameText text;
    if (session.isReplaying()) {
        text.title = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Recording"));
        if (!now.running) text.line = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Space plays it"));
        text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "G: go on from here · Ctrl+W: close"));
        text.clock = clockText(session.stopwatch(now));
        return text;
    }
    if (session.isInPast()) {
        text.title = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Looking back"));
        text.line = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Space plays it · G goes on from here"));
        text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "so does any change · Esc: the present"));
        text.clock = clockText(session.stopwatch(now));
        return text;
    }
    switch (game.phase()) {
    case Game::Phase::Prompt:
        if (now.running || now.current.step > 0) {
            text = freeRunText(session, title, now);
            break;
        }
        text.title = title;
        text.line = session.isBallPut()
                        ? say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Press Enter to start from here"))
                        : say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Press Enter to start"));
        text.hint = promptHint(session);
        break;
    case Game::Phase::Playing:
        text.title = title;
        text.clock = clockText(session.stopwatch(now));
        text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "%1 · Space: pause")).arg(tiltHint(session));
        if (now.running) break;
        text.title = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Paused"));
        text.line = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Space goes on"));
        text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "R restarts the level"));
        break;
    case Game::Phase::Won:
        text.isResult = true;
        text.clock = clockText(game.time());
        text.title = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "%1 done")).arg(title);
        text.line = winLine(session, game);
        text.hint = game.nextLevel()
                        ? say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Enter: %1 · R: again"))
                              .arg(levelTitle(session, session.levels().listed()[size_t(*game.nextLevel())]))
                        : say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Enter or R: again"));
        break;
    case Game::Phase::Lost:
        text.isResult = true;
        text.clock = clockText(game.time());
        text.title = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "%1: lost")).arg(title);
        text.line = lossLine(session);
        text.hint = say(QT_TRANSLATE_NOOP("inspector::ui::GameStrip", "Enter: again · R: back to the start"));
        break;
    }
    return text;
}

/// What remains of a result after it was closed.
GameText closed(const GameText &result) {
    QStringList parts{result.title, result.line, result.hint};
    parts.removeAll(QString());
    GameText text;
    text.hint = parts.join(QStringLiteral(" · "));
    text.clock = result.clock;
    return text;
}

} // namespace

GameText gameText(Session &session, const Snapshot &now) {
    GameText text = stateText(session, now);
    if (const QString wait = waitHint(now); !wait.isEmpty()) text.hint = wait;
    return text;
}

GameStrip::GameStrip(QWidget *parent)
    : QFrame(parent)
    , m_title(new ElidedLabel)
    , m_line(new ElidedLabel)
    , m_hint(new ElidedLabel)
    , m_clock(new QLabel)
    , m_close(new QToolButton) {
    setObjectName(QStringLiteral("game_strip"));
    for (ElidedLabel *label : {m_title, m_line}) label->setWidest({}); // as wide as their texts if there is room
    m_title->setLeast(int(tr("Level 10 done").size()));
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_close->setObjectName(QStringLiteral("game_strip_close"));
    m_close->setIcon(glyphIcon(Glyph::Close));
    m_close->setToolTip(tr("Close (Esc)"));
    m_close->setAutoRaise(true);
    m_close->setFocusPolicy(Qt::NoFocus);
    connect(m_close, &QToolButton::clicked, this, &GameStrip::dismiss);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 2, 6, 2);
    layout->setSpacing(14);
    for (ElidedLabel *label : {m_title, m_line}) label->setContentsMargins(0, 0, 8, 0);
    layout->addWidget(flowOf({m_title, m_line, m_hint}), 1, Qt::AlignVCenter); // more lines where there is no room
    layout->addWidget(m_close);
    layout->addWidget(m_clock);
    takeFont();
    show(GameText{});
    QFrame::show();
}

void GameStrip::takeFont() {
    m_title->setFont(scaled(font(), 1.15, true));
    m_line->setFont(scaled(font(), 1.15, false));
    QFont digits = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    digits.setPointSizeF(font().pointSizeF());
    m_clock->setFont(scaled(digits, 1.3, true));
    setMinimumHeight(std::max(m_clock->sizeHint().height(), m_close->sizeHint().height()) + 6);
}

void GameStrip::changeEvent(QEvent *event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::FontChange) takeFont();
}

void GameStrip::setText(const GameText &text) {
    if (text != m_dismissed) m_dismissed = {};
    const GameText shown = text == m_dismissed ? closed(text) : text;
    if (shown != m_text) show(shown);
}

void GameStrip::show(const GameText &text) {
    m_text = text;
    const std::pair<ElidedLabel *, QString> parts[] = {{m_title, text.title}, {m_line, text.line}, {m_hint, text.hint}};
    for (const auto &[label, part] : parts) {
        label->setText(part);
        label->setVisible(!part.isEmpty());
    }
    m_clock->setText(text.clock);
    m_close->setVisible(text.isResult);
}

bool GameStrip::dismiss() {
    if (!m_text.isResult) return false;
    m_dismissed = m_text;
    show(closed(m_dismissed));
    return true;
}

void GameStrip::mousePressEvent(QMouseEvent *) { dismiss(); }

} // namespace inspector::ui
