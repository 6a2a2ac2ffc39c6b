// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/game/level_panel.h"

#include "ui/game/clock_text.h"
#include "ui/game/game_strip.h"

#include <QEvent>
#include <QHeaderView>
#include <QSignalBlocker>

#include <algorithm>

namespace inspector::ui {

LevelPanel::LevelPanel(Session &session, QWidget *parent)
    : QTreeWidget(parent)
    , m_session(session) {
    setObjectName(QStringLiteral("levels"));
    setFrameShape(QFrame::NoFrame);
    setRootIsDecorated(false);
    setAlternatingRowColors(true);
    setFocusPolicy(Qt::TabFocus); // a click doesn't take the keyboard from the game
    setHeaderLabels({tr("Level"), tr("Best time")});
    header()->setStretchLastSection(true);
    header()->setSectionsMovable(false);
    setUniformRowHeights(true);
    for (const Level &level : session.levels().listed()) new QTreeWidgetItem(this, {levelTitle(session, level)});
    fitNames();

    connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem *item) {
        m_session.game().choose(indexOfTopLevelItem(item));
        // Also after a refusal, and once the press that chose it has selected its row.
        QMetaObject::invokeMethod(this, &LevelPanel::showState, Qt::QueuedConnection);
    });
    connect(&session, &Session::levelOpened, this, &LevelPanel::showState);
    connect(&session.game(), &Game::phaseChanged, this, &LevelPanel::showState);
    showState();
}

void LevelPanel::fitNames() {
    constexpr int kLeast = 130; // pixels
    setColumnWidth(0, std::max(kLeast, sizeHintForColumn(0)));
}

void LevelPanel::changeEvent(QEvent *event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitNames();
}

void LevelPanel::showState() {
    const QSignalBlocker silent(this);
    setCurrentItem(nullptr); // none: a file outside of the list
    for (int i = 0; i < topLevelItemCount(); ++i) {
        const std::optional<double> best = m_session.game().bestTime(i);
        topLevelItem(i)->setText(1, best ? clockText(*best) : QStringLiteral("–"));
        if (m_session.levels().listed()[size_t(i)].path == m_session.level().path) setCurrentItem(topLevelItem(i));
    }
}

} // namespace inspector::ui
