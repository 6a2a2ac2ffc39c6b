// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_dialogs.h"

#include "core/setup/tables.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

namespace inspector::ui {

namespace {

struct Help {
    Q_DECLARE_TR_FUNCTIONS(Help)
};

QString row(const QString &left, const QString &right) {
    return QStringLiteral("<tr><td style='padding-right: 24px'><b>%1</b></td><td>%2</td></tr>")
        .arg(left.toHtmlEscaped(), right.toHtmlEscaped());
}

QString keysTable(const QWidget &window) {
    QString rows = row(Help::tr("Arrow keys"), Help::tr("Tilt the board"));
    for (const QAction *action : window.actions()) {
        if (action->shortcut().isEmpty()) continue;
        rows += row(action->shortcut().toString(QKeySequence::NativeText), action->text().remove(QLatin1Char('&')));
    }
    const QString gestures[][2] = {
        {Help::tr("View: drag"), Help::tr("Turn; with the right button move")},
        {Help::tr("View: wheel"), Help::tr("Come closer to what is under the cursor")},
        {Help::tr("View: click"), Help::tr("Look at the bounce there, or at none")},
        {Help::tr("View: double click"), Help::tr("Show the whole board again")},
        {Help::tr("Plot: drag, wheel"), Help::tr("Move and zoom the time; with Ctrl or over the axis the values")},
        {Help::tr("Plot: double click"), Help::tr("Follow the newest values again")},
    };
    for (const auto &gesture : gestures) rows += row(gesture[0], gesture[1]);
    return QStringLiteral("<table cellspacing='3'>%1</table>").arg(rows);
}

QString partsTable(const QString &renderer) {
    const QString parts[][2] = {
        {Help::tr("This program"), QStringLiteral("GPL-3.0-or-later")},
        {QStringLiteral("libphysics %1").arg(QLatin1String(phys_version())), QStringLiteral("MIT")},
        {QStringLiteral("Qt %1").arg(QLatin1String(qVersion())), QStringLiteral("LGPL-3.0")},
        {QStringLiteral("QCustomPlot"), QStringLiteral("GPL-3.0-or-later")},
        {QStringLiteral("GLM, tinyobjloader"), QStringLiteral("MIT")},
    };
    QString rows;
    for (const auto &part : parts) rows += row(part[0], part[1]);
    rows += row(Help::tr("Drawn by"), renderer);
    return QStringLiteral("<table cellspacing='3'>%1</table>").arg(rows);
}

void showText(QWidget &window, const char *name, const QString &title, const QString &html) {
    auto *dialog = new QDialog(&window);
    dialog->setObjectName(QLatin1String(name));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto *text = new QLabel(html);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->show();
}

} // namespace

void showKeysDialog(QWidget &window) { showText(window, "keys_dialog", Help::tr("Keys"), keysTable(window)); }

void showAboutDialog(QWidget &window, const QString &renderer) {
    const QString head = QStringLiteral("<h3>%1</h3><p>%2</p>")
                             .arg(versionLine().toHtmlEscaped(),
                                  Help::tr("One ball in a maze of boxes: tilt it, tune it, look at every step."));
    showText(window, "about_dialog", Help::tr("About"), head + partsTable(renderer));
}

} // namespace inspector::ui
