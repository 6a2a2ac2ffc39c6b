// SPDX-License-Identifier: MIT
// The window for those who see little, hear it read, or use the keyboard alone.
#include "inspector/contrast.h"
#include "ui/parts/theme.h"
#include "window_fixture.h"

#include <QAccessible>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>

#include <qcustomplot.h>

using namespace window_test;
using inspector::ui::Theme;

class TestWindowAccess : public WindowSuite {
    Q_OBJECT

private slots:
    void cleanup() override;
    void whatTakesTheKeyboardHasANameToBeRead();
    void dialogsHaveNamesToBeRead_data();
    void dialogsHaveNamesToBeRead();
    void iconsGrowWithTheTexts();
    void valueAxisIsWhole_data();
    void valueAxisIsWhole();
    void whatHasTheKeyboardIsSeen_data();
    void whatHasTheKeyboardIsSeen();
    void restOfTheToolbarIsSeen_data();
    void restOfTheToolbarIsSeen();
    void listsShowNamesAndValuesWhole();
    void keysZoomAndMoveAPlot();
    void keyboardLeavesADockThatGoesBehindAnother();

private:
    void chooseTextSize(int number) { m_fixture->trigger(QStringLiteral("text_size_%1").arg(number)); }
    void chooseTheme(Theme theme);
    static QStringList namelessIn(const QWidget &window);
};

void TestWindowAccess::cleanup() {
    inspector::ui::applyTextScale(1.0);
    inspector::ui::applyTheme(Theme::System);
    m_fixture.reset();
}

void TestWindowAccess::chooseTheme(Theme theme) {
    m_fixture->trigger(QStringLiteral("theme_%1").arg(int(theme)));
    QTRY_COMPARE(m_fixture->window().palette(), QApplication::palette());
}

// Widgets that a screen reader meets; those inside of lists, number boxes and file dialogs are Qt's.
QStringList TestWindowAccess::namelessIn(const QWidget &window) {
    QStringList nameless;
    for (QWidget *widget : window.findChildren<QWidget *>()) {
        const bool isQts = widget->objectName().startsWith(QLatin1String("qt_"));
        if (isQts || !widget->isVisible() || widget->focusPolicy() == Qt::NoFocus) continue;
        const QAccessibleInterface *read = QAccessible::queryAccessibleInterface(widget);
        const QString what = QLatin1String(widget->metaObject()->className()) + QLatin1Char(' ') + widget->objectName();
        if (!read || read->text(QAccessible::Name).isEmpty()) nameless << what;
        if (read && read->text(QAccessible::Description).contains('<')) nameless << what + " (tags)";
    }
    return nameless;
}

void TestWindowAccess::whatTakesTheKeyboardHasANameToBeRead() {
    for (const QDockWidget *dock : m_fixture->window().findChildren<QDockWidget *>())
        if (dock->isHidden()) m_fixture->trigger("show_" + dock->objectName());
    const QStringList nameless = namelessIn(m_fixture->window());
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(", ")));
}

void TestWindowAccess::dialogsHaveNamesToBeRead_data() {
    QTest::addColumn<QString>("action");
    for (const char *action : {"save_film", "keys", "page_inspector", "about"}) QTest::newRow(action) << action;
}

void TestWindowAccess::dialogsHaveNamesToBeRead() {
    QFETCH(QString, action);
    m_fixture->makeSteps(1);
    m_fixture->trigger(action);
    QTRY_VERIFY(m_fixture->window().findChild<QDialog *>());
    const QStringList nameless = namelessIn(*m_fixture->window().findChild<QDialog *>());
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(", ")));
}

void TestWindowAccess::iconsGrowWithTheTexts() {
    const auto *bar = m_fixture->find<QToolBar>("transport");
    const auto *button = m_fixture->find<QToolButton>("plot_follow");
    const int inBar = bar->iconSize().height();
    const int inDock = button->iconSize().height();
    chooseTextSize(3);
    QTRY_COMPARE(bar->iconSize().height(), 2 * inBar);
    QCOMPARE(button->iconSize().height(), 2 * inDock);
}

void TestWindowAccess::valueAxisIsWhole_data() {
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("notches"); // of the wheel, over the values
    for (int size = 0; size < int(inspector::ui::kTextScales.size()); ++size) {
        QTest::addRow("size %d", size) << size << 0;
        QTest::addRow("size %d, a small part of the values", size) << size << 30;
    }
}

// What is cut off ends at the border of the plot.
void TestWindowAccess::valueAxisIsWhole() {
    QFETCH(int, size);
    QFETCH(int, notches);
    auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    m_fixture->makeSteps(2);
    chooseTextSize(size);
    QApplication::processEvents();
    m_fixture->window().refresh();
    const QPoint values(plot->axisRect()->left() - 10, plot->axisRect()->center().y());
    for (int notch = 0; notch < notches; ++notch) turnWheel(plot, values, 1);
    m_fixture->window().refresh();
    plot->replot(QCustomPlot::rpImmediateRefresh);
    const QImage picture = plot->grab().toImage();
    const QColor base = plot->palette().color(QPalette::Base);
    for (int y = 0; y < picture.height(); ++y)
        QVERIFY2(picture.pixelColor(0, y) == base, qPrintable(QStringLiteral("at %1").arg(y)));
}

void TestWindowAccess::whatHasTheKeyboardIsSeen_data() {
    QTest::addColumn<Theme>("theme");
    QTest::addColumn<QByteArray>("kind");
    for (const char *kind :
         {"QToolButton", "QPushButton", "QCheckBox", "QComboBox", "QLineEdit", "QSlider", "QCustomPlot"}) {
        QTest::addRow("%s, light", kind) << Theme::Light << QByteArray(kind);
        QTest::addRow("%s, dark", kind) << Theme::Dark << QByteArray(kind);
    }
}

// By the contrast that WCAG 2.1 (1.4.11) asks for.
void TestWindowAccess::whatHasTheKeyboardIsSeen() {
    QFETCH(Theme, theme);
    QFETCH(QByteArray, kind);
    chooseTheme(theme);
    const auto hasIt = [&] {
        const QWidget *widget = QApplication::focusWidget();
        return widget && widget->inherits(kind) && widget->isEnabled();
    };
    for (int i = 0; i < 100 && !hasIt(); ++i) m_fixture->key(Qt::Key_Tab);
    QVERIFY(hasIt());
    QWidget *widget = QApplication::focusWidget();
    QTest::keyClick(widget, Qt::Key_Home); // without a selection, if it is a text
    const QImage with = widget->grab().toImage();
    m_fixture->window().view().setFocus();
    const QImage without = widget->grab().toImage();
    double best = 1.0;
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x)
            best = std::max(best, support::contrastOf(with.pixelColor(x, y), without.pixelColor(x, y)));
    QVERIFY2(best >= 3.0, qPrintable(QString::number(best)));
}

// What doesn't fit into the toolbar is behind a button of Qt's.
void TestWindowAccess::restOfTheToolbarIsSeen_data() {
    QTest::addColumn<Theme>("theme");
    QTest::newRow("light") << Theme::Light;
    QTest::newRow("dark") << Theme::Dark;
}

void TestWindowAccess::restOfTheToolbarIsSeen() {
    QFETCH(Theme, theme);
    chooseTheme(theme);
    m_fixture->trigger("text_size_3");
    m_fixture->window().resize(640, 500);
    auto *rest = m_fixture->find<QToolButton>("qt_toolbar_ext_button");
    QTRY_VERIFY(rest->isVisible());
    const QImage picture = rest->grab().toImage();
    double best = 1.0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            best = std::max(best, support::contrastOf(picture.pixelColor(x, y), picture.pixelColor(0, 0)));
    QVERIFY2(best >= 3.0, qPrintable(QString::number(best)));
}

void TestWindowAccess::listsShowNamesAndValuesWhole() {
    m_fixture->trigger("show_watch_dock");
    chooseTextSize(3);
    m_fixture->makeSteps(7);
    m_fixture->window().refresh();
    for (const char *name : {"levels", "watched"}) {
        const auto *list = m_fixture->find<QTreeWidget>(name);
        for (int row = 0; row < list->topLevelItemCount(); ++row)
            for (int column = 0; column < 2; ++column) {
                const QString text = list->topLevelItem(row)->text(column);
                QVERIFY2(list->fontMetrics().horizontalAdvance(text) < list->columnWidth(column), qPrintable(text));
            }
    }
}

void TestWindowAccess::keysZoomAndMoveAPlot() {
    auto *plot = m_fixture->find<QCustomPlot>("velocity_plot");
    m_fixture->makeSteps(1);
    m_fixture->window().refresh();
    for (int i = 0; i < 100 && !plot->hasFocus(); ++i) m_fixture->key(Qt::Key_Tab);
    QVERIFY(plot->hasFocus());
    const QCPRange times = plot->xAxis->range();
    const QCPRange values = plot->yAxis->range();
    m_fixture->key(Qt::Key_Plus);
    QCOMPARE(plot->xAxis->range(), QCPRange(0.0, 0.8 * times.size()));
    m_fixture->key(Qt::Key_Minus);
    QCOMPARE(plot->xAxis->range().size(), times.size());
    m_fixture->key(Qt::Key_PageDown);
    QCOMPARE(plot->xAxis->range().lower, times.lower + 0.5 * times.size());
    m_fixture->key(Qt::Key_PageUp);
    QCOMPARE(plot->xAxis->range().lower, times.lower);
    QCOMPARE(plot->yAxis->range(), values);
    m_fixture->key(Qt::Key_Plus, Qt::ControlModifier);
    const QCPRange zoomed = plot->yAxis->range();
    QCOMPARE(zoomed.size(), 0.8 * values.size());
    QVERIFY(!m_fixture->find<QToolButton>("plot_follow")->isChecked());
    m_fixture->key(Qt::Key_0);
    QVERIFY(m_fixture->find<QToolButton>("plot_follow")->isChecked());
    QTRY_VERIFY(plot->yAxis->range() != zoomed); // fitted again
}

void TestWindowAccess::keyboardLeavesADockThatGoesBehindAnother() {
    m_fixture->trigger("show_comparison_dock");
    auto *box = m_fixture->find<QLineEdit>("comparison_substeps");
    box->setFocus();
    QTRY_VERIFY(box->hasFocus());
    m_fixture->type("x");
    for (QTabBar *bar : m_fixture->window().findChildren<QTabBar *>())
        for (int tab = 0; tab < bar->count(); ++tab)
            if (bar->tabText(tab).remove('&') == QLatin1String("Plots"))
                QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(tab).center());
    QTRY_VERIFY(box->visibleRegion().isEmpty());
    QTRY_VERIFY(!box->hasFocus());
    QVERIFY(m_fixture->window().view().hasFocus());
}

QTEST_MAIN(TestWindowAccess)
#include "tst_window_access.moc"
