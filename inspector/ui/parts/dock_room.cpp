// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parts/dock_room.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QTabBar>

#include <algorithm>
#include <iterator>
#include <utility>

namespace inspector::ui {

namespace {

constexpr QSize kLeastView(400, 150); ///< logical pixels that docks leave to the view
constexpr int kLeastSize = 100;       ///< logical pixels that the view leaves to docks
constexpr Qt::DockWidgetArea kAreas[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea, Qt::TopDockWidgetArea,
                                         Qt::BottomDockWidgetArea};

/// In which docks of the area take room from the view.
Qt::Orientation across(Qt::DockWidgetArea area) {
    return area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea ? Qt::Horizontal : Qt::Vertical;
}

int along(Qt::Orientation orientation, const QSize &size) {
    return orientation == Qt::Horizontal ? size.width() : size.height();
}

bool isSeen(const QDockWidget *dock) { return !dock->visibleRegion().isEmpty(); }

/// Together with the tabs of those behind it.
QRect placeOf(const QDockWidget &dock) {
    QRect place = dock.geometry();
    for (const QTabBar *tabs : dock.parentWidget()->findChildren<QTabBar *>(Qt::FindDirectChildrenOnly))
        if (tabs->isVisible() && tabs->geometry().adjusted(-1, -1, 1, 1).intersects(dock.geometry()))
            place |= tabs->geometry();
    return place;
}

} // namespace

DockRoom::DockRoom(QMainWindow &window, const QWidget &view)
    : QObject(&window)
    , m_window(window)
    , m_view(view) {
    window.installEventFilter(this);
}

DockRoom::Side DockRoom::seen(Qt::DockWidgetArea area) const {
    Side side;
    QRect all;
    for (QDockWidget *dock : m_window.findChildren<QDockWidget *>(Qt::FindDirectChildrenOnly)) {
        if (m_window.dockWidgetArea(dock) != area || dock->isFloating() || dock->isHidden()) continue;
        side.docks += dock;
        if (isSeen(dock)) all |= placeOf(*dock);
    }
    side.size = along(across(area), all.size());
    return side;
}

void DockRoom::follow() {
    if (!m_window.isVisible()) return;
    const bool isResized = std::exchange(m_isResized, false);
    for (const Qt::DockWidgetArea area : kAreas) {
        Side &side = m_sides[area];
        if (isResized && !side.docks.isEmpty())
            fit(area);
        else
            followUser(side, seen(area));
    }
}

/// Sizes also change by themselves, as the docks' contents do.
void DockRoom::followUser(Side &side, const Side &now) const {
    const bool isMoving = now.docks != side.docks || (side.isNew && now.size != side.size);
    const bool isUsers = isMoving || m_isSeparatorHeld;
    if (isUsers && now.size != side.size) side.wanted = now.size;
    side = {now.docks, now.size, side.wanted, isMoving};
}

void DockRoom::want(Qt::DockWidgetArea area, int size) {
    Side &side = m_sides[area];
    side = seen(area);
    side.wanted = size;
    m_isResized = true; // fitted once they are laid out
}

QStringList DockRoom::stored() const {
    QStringList sizes;
    for (const Qt::DockWidgetArea area : kAreas) sizes += QString::number(wanted(area));
    return sizes;
}

/// The window may have been too small for it.
void DockRoom::restore(const QStringList &sizes) {
    forget();
    if (sizes.size() != std::ssize(kAreas)) return;
    for (qsizetype i = 0; i < sizes.size(); ++i)
        if (const int size = std::clamp(sizes[i].toInt(), 0, QWIDGETSIZE_MAX); size > 0) want(kAreas[i], size);
}

void DockRoom::fit(Qt::DockWidgetArea area) {
    const Side now = seen(area);
    const int wanted = this->wanted(area);
    const Qt::Orientation orientation = across(area);
    const int most = now.size + along(orientation, m_view.size()) - along(orientation, kLeastView);
    const int size = std::clamp(most, std::min(kLeastSize, wanted), wanted);
    if (size == now.size) return;
    QList<QDockWidget *> docks;
    QList<int> sizes;
    for (QDockWidget *dock : now.docks) {
        if (!isSeen(dock)) continue;
        docks += dock;
        sizes += along(orientation, placeOf(*dock).size()) * size / now.size;
    }
    m_window.resizeDocks(docks, sizes, orientation);
}

/// Only the separators between docks and view are pressed on the window itself.
bool DockRoom::eventFilter(QObject *, QEvent *event) {
    if (event->type() == QEvent::Resize) m_isResized = true;
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease) {
        follow(); // so that nothing earlier, and all of it, counts as the user's
        m_isSeparatorHeld = event->type() == QEvent::MouseButtonPress;
    }
    return false;
}

} // namespace inspector::ui
