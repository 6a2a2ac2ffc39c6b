// SPDX-License-Identifier: MIT
// A trade that was measured in the window leaves it: as a table, as a picture, by the clipboard.
#include "inspector/dock_fixture.h"
#include "ui/trade/trade_dock.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>

using namespace inspector;
using namespace inspector::ui;

class TestTradeFiles : public QObject, support::DockFixture<TradeDock> {
    Q_OBJECT

private slots:
    void initTestCase();
    void nothingIsSavedBeforeAMeasurement();
    void figuresAreSaved_data();
    void figuresAreSaved();
    void savedChartNamesItsCurves();
    void savedTableHasItsSettingsBeside();
    void rowsAreCopiedAsTextAndTable();

private:
    void measure();
    void clickFirstRow();
    QTableView &table() { return find<QTableView>("trade_table"); }
    QString saved(const char *name) { return m_folder.filePath(QLatin1String(name)); }
};

void TestTradeFiles::initTestCase() {
    const QString error = open(1);
    QVERIFY2(error.isEmpty(), qPrintable(error));
}

void TestTradeFiles::measure() {
    auto &duration = find<QLineEdit>("trade_duration");
    QTest::mouseClick(&duration, Qt::LeftButton);
    duration.selectAll();
    QTest::keyClicks(&duration, "0.5");
    QTest::keyClick(&duration, Qt::Key_Return);
    auto &button = find<QPushButton>("trade_measure");
    QTest::mouseClick(&button, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(button.text(), QString("Measure"), kLong);
    QVERIFY(table().model()->rowCount() > 0);
}

void TestTradeFiles::clickFirstRow() {
    const QPoint place = table().visualRect(table().model()->index(0, 0)).center();
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place);
}

void TestTradeFiles::nothingIsSavedBeforeAMeasurement() {
    QSignalSpy wanted(m_dock.get(), &TradeDock::saveWanted);
    QTest::mouseClick(&find<QToolButton>("trade_save"), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QString error;
    QVERIFY(!m_dock->save(saved("early.csv"), &error));
    QVERIFY2(error.endsWith("early.csv: nothing has been measured yet"), qPrintable(error));
    QVERIFY(!QFile::exists(saved("early.csv")));
    measure();
}

void TestTradeFiles::figuresAreSaved_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("beginning");
    QTest::newRow("csv") << QByteArray("trade.csv") << QByteArray("stepper,dt [s],model,");
    QTest::newRow("png") << QByteArray("trade.png") << QByteArray("\x89PNG");
    QTest::newRow("pdf") << QByteArray("trade.pdf") << QByteArray("%PDF-");
    QTest::newRow("svg") << QByteArray("trade.svg") << QByteArray("<svg ");
}

void TestTradeFiles::figuresAreSaved() {
    QFETCH(const QByteArray, name);
    QFETCH(const QByteArray, beginning);
    QString error;
    QVERIFY2(m_dock->save(saved(name.constData()), &error), qPrintable(error));
    QFile file(saved(name.constData()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.read(beginning.size()), beginning);
}

// Right of the curves, also where the dock has no room for it.
void TestTradeFiles::savedChartNamesItsCurves() {
    m_dock->resize(400, 300);
    QString error;
    QVERIFY2(m_dock->save(saved("trade.png"), &error), qPrintable(error));
    const QImage picture(saved("trade.png"));
    int drawn = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = picture.width() * 85 / 100; x < picture.width(); ++x)
            drawn += picture.pixel(x, y) != qRgb(255, 255, 255);
    QVERIFY2(drawn > 500, qPrintable(QString::number(drawn)));
}

// Those of the measurement, whatever is set since.
void TestTradeFiles::savedTableHasItsSettingsBeside() {
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 1.62}}));
    QString error;
    QVERIFY2(m_dock->save(saved("trade.csv"), &error), qPrintable(error));
    QVERIFY(m_session->parameters().set({{QStringLiteral("gravity"), 9.81}}));
    QFile settings(saved("trade.csv.txt"));
    QVERIFY(settings.open(QIODevice::ReadOnly));
    const QByteArray text = settings.readAll();
    for (const char *line : {"\nlevel 01\n", "\ngravity 9.81 m/s^2\n", "\nschedule busy", "\nunknown "})
        QVERIFY2(text.contains(line), text.constData());
}

void TestTradeFiles::rowsAreCopiedAsTextAndTable() {
    const auto copied = [](const char *type) { // its lines
        const QByteArray all = QGuiApplication::clipboard()->mimeData()->data(QLatin1String(type));
        return all.trimmed().split('\n');
    };
    clickFirstRow();
    QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
    QVERIFY2(copied("text/csv")[0].startsWith("stepper,dt [s],model,"), copied("text/csv")[0].constData());
    QCOMPARE(copied("text/csv").size(), 2); // with the header
    QTest::keyClick(&table(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(copied("text/csv").size(), table().model()->rowCount() + 1);
    QCOMPARE(copied("text/plain").size(), table().model()->rowCount() + 1);
    QVERIFY2(copied("text/plain")[0].startsWith("stepper\tdt [s]\tmodel\t"), copied("text/plain")[0].constData());
    QVERIFY(!find<QPushButton>("trade_use").isEnabled()); // which one?
    clickFirstRow();
    QVERIFY(find<QPushButton>("trade_use").isEnabled());
}

QTEST_MAIN(TestTradeFiles)
#include "tst_trade_files.moc"
