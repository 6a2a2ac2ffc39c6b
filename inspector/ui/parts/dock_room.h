// SPDX-License-Identifier: GPL-3.0-or-later
// The room that docks take around a window's view. Qt takes from the docks what a smaller window lacks, but leaves them
// small when it grows again, and gives everything to the view. Here they get back what they had.
#pragma once

#include <QHash>
#include <QList>
#include <QObject>
#include <QStringList>

class QDockWidget;
class QMainWindow;

namespace inspector::ui {

class DockRoom : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    DockRoom(QMainWindow &window, const QWidget &view);

    /// Takes over what the user did to the docks, and fits them to a window that was resized; called regularly, and
    /// once such a window is laid out.
    void follow();
    /// Logical pixels across the docks of an area, as soon as the window has them.
    int wanted(Qt::DockWidgetArea area) const { return m_sides.value(area).wanted; }
    void want(Qt::DockWidgetArea area, int size);
    /// The layout was replaced by one with sizes of its own.
    void forget() { m_sides.clear(); }
    /// What the docks want, in the order of the areas, and a layout that was stored with it.
    QStringList stored() const;
    void restore(const QStringList &sizes);

protected:
    bool eventFilter(QObject *window, QEvent *event) override;

private:
    /// The docks of an area.
    struct Side {
        QList<QDockWidget *> docks; ///< also those behind others
        int size = 0;               ///< across, as it was last
        int wanted = 0;
        bool isNew = false; ///< docks came or went, and may still be moving to their places
    };

    Side seen(Qt::DockWidgetArea area) const;
    void followUser(Side &side, const Side &now) const;
    void fit(Qt::DockWidgetArea area);

    QMainWindow &m_window;
    const QWidget &m_view;
    QHash<Qt::DockWidgetArea, Side> m_sides;
    bool m_isResized = false; ///< the window, since the last follow()
    bool m_isSeparatorHeld = false;
};

} // namespace inspector::ui
