// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_dialogs.h"

#include "core/setup/tables.h"
#include "ui/input/menu_letters.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace inspector::ui {

namespace {

constexpr double kLargestShare = 0.8; ///< share of the screen that a dialog takes at most

struct Help {
    Q_DECLARE_TR_FUNCTIONS(Help)
};

QString row(const QString &left, const QString &right) {
    return QStringLiteral("<tr><td style='padding-right: 24px'><b>%1</b></td><td>%2</td></tr>")
        .arg(left.toHtmlEscaped(), right.toHtmlEscaped());
}

/// The rows of the table that contain this text.
QString keysTable(const QWidget &window, const QString &sought) {
    QString rows;
    const auto add = [&](const QString &left, const QString &right) {
        const bool isWanted = left.contains(sought, Qt::CaseInsensitive) || right.contains(sought, Qt::CaseInsensitive);
        if (isWanted) rows += row(left, right);
    };
    add(Help::tr("Arrow keys"), Help::tr("Tilt the board as the screen shows it"));
    for (const QAction *action : window.actions()) {
        if (action->shortcut().isEmpty()) continue;
        add(action->shortcut().toString(QKeySequence::NativeText), plainText(action->text()));
    }
    const QString gestures[][2] = {
        {Help::tr("View: drag"), Help::tr("Turn; with the right button move")},
        {Help::tr("View: wheel"), Help::tr("Come closer to what is under the cursor")},
        {Help::tr("View: drag the ball"),
         Help::tr("Put it elsewhere, while everything stands; with Ctrl its velocity")},
        {Help::tr("View: click"), Help::tr("Look at the bounce there, or at none")},
        {Help::tr("View: drag with Shift"), Help::tr("Measure a length and an angle on the floor")},
        {Help::tr("View: double click"), Help::tr("Show the whole board again")},
        {Help::tr("Plot: drag, wheel"), Help::tr("Move and zoom the time; with Ctrl or over the axis the values")},
        {Help::tr("Plot reached by Tab: + and -"), Help::tr("Zoom the time; with Ctrl the values")},
        {Help::tr("Plot reached by Tab: PageUp, PageDown, 0"),
         Help::tr("Move the time; follow the newest values again")},
        {Help::tr("Plot: double click"), Help::tr("Follow the newest values again")},
        {Help::tr("Plot: right click"), Help::tr("Choose what it shows; add or remove plots")},
        {Help::tr("Slider, number: with Shift"), Help::tr("Ten times finer")},
    };
    for (const auto &gesture : gestures) add(gesture[0], gesture[1]);
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

/// Page keys scroll the text whatever has the focus.
class PageKeys : public QObject {
public:
    PageKeys(QDialog &dialog, QScrollBar &bar)
        : QObject(&dialog)
        , m_bar(bar) {
        dialog.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject *, QEvent *event) override {
        if (event->type() != QEvent::KeyPress) return false;
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key != Qt::Key_PageDown && key != Qt::Key_PageUp) return false;
        m_bar.triggerAction(key == Qt::Key_PageDown ? QAbstractSlider::SliderPageStepAdd
                                                    : QAbstractSlider::SliderPageStepSub);
        return true;
    }

private:
    QScrollBar &m_bar;
};

/// Makes a dialog of a text, which scrolls on a small screen; returns its label.
QLabel *textDialog(QWidget &window, const char *name, const QString &title, const QString &html) {
    auto *dialog = new QDialog(&window);
    dialog->setObjectName(QLatin1String(name));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto *text = new QLabel(html);
    text->setTextFormat(Qt::RichText);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *area = new QScrollArea;
    area->setWidget(text);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setAccessibleName(title);
    new PageKeys(*dialog, *area->verticalScrollBar());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(area);
    layout->addWidget(buttons);
    const QSize wanted = text->sizeHint() + QSize(60, 110); // including scroll bars and buttons
    dialog->resize(wanted.boundedTo(window.screen()->availableSize() * kLargestShare));
    return text;
}

} // namespace

void showKeysDialog(QWidget &window) {
    QLabel *text = textDialog(window, "keys_dialog", Help::tr("Keys"), keysTable(window, {}));
    text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto *sought = new QLineEdit;
    sought->setObjectName(QStringLiteral("keys_sought"));
    sought->setPlaceholderText(Help::tr("Search"));
    sought->setAccessibleName(Help::tr("Search the keys"));
    sought->setClearButtonEnabled(true);
    QObject::connect(sought, &QLineEdit::textChanged, text,
                     [text, &window](const QString &wanted) { text->setText(keysTable(window, wanted)); });
    static_cast<QVBoxLayout *>(text->window()->layout())->insertWidget(0, sought);
    sought->setFocus(); // before showing: otherwise the dialog gives the focus to its first widget
    text->window()->show();
}

void showAboutDialog(QWidget &window, const QString &renderer) {
    const QString head = QStringLiteral("<h3>%1</h3><p>%2</p>")
                             .arg(versionLine().toHtmlEscaped(),
                                  Help::tr("One ball in a maze of boxes: tilt it, tune it, look at every step."));
    textDialog(window, "about_dialog", Help::tr("About"), head + partsTable(renderer))->window()->show();
}

} // namespace inspector::ui
