// SPDX-License-Identifier: MIT
// What a saved plot shows to a reader who doesn't have the window.
#include "support/files.h"
#include "ui/plots/plot_stack.h"
#include "window_fixture.h"

#include <QFontInfo>
#include <QImage>
#include <QRegularExpression>

#include <memory>

using namespace window_test;
using inspector::ui::PlotStack;

class TestWindowSavedPlots : public WindowSuite {
    Q_OBJECT

private slots:
    void init() override;
    void pictureHasNoHint_data();
    void pictureHasNoHint();
    void documentHasAllPlots();
    void textsOfADocumentAreAsLargeAsOnTheScreen();
    void pictureOfLowPlotsHasRoomForTheirLabels();

private:
    PlotStack &plots() { return *m_fixture->find<PlotStack>("plots"); }
    QString save(const QString &name);
};

namespace {

// What is drawn on its page: the streams that can be decompressed.
QByteArray drawingOf(const QByteArray &pdf) {
    const QByteArray begin = "stream\n";
    QByteArray text;
    for (qsizetype at = pdf.indexOf(begin); at >= 0; at = pdf.indexOf(begin, at + 1)) {
        const qsizetype from = at + begin.size();
        const QByteArray packed = pdf.mid(from, pdf.indexOf("endstream", from) - from);
        const QByteArray length("\0\x10\0\0", 4); // an estimate, which qUncompress() expects in front
        text += qUncompress(length + packed);
    }
    return text;
}

} // namespace

void TestWindowSavedPlots::init() {
    QVERIFY(open());
    m_fixture->makeSteps(20);
    m_fixture->window().refresh();
}

QString TestWindowSavedPlots::save(const QString &name) {
    m_fixture->key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    m_fixture->answerFile(m_fixture->path(name));
    return m_fixture->path(name);
}

void TestWindowSavedPlots::pictureHasNoHint_data() {
    QTest::addColumn<int>("count");
    QTest::newRow("one plot") << 1;
    QTest::newRow("two plots") << 2;
}

// Beside the legend, where the window has it; it is there again afterwards.
void TestWindowSavedPlots::pictureHasNoHint() {
    QFETCH(int, count);
    if (count == 2) plots().addPlot(inspector::ui::plotContentOf("energy"));
    m_fixture->window().refresh();
    auto &first = plots().first();
    first.replot(QCustomPlot::rpImmediateRefresh);
    const auto *hint = first.findChild<QCPTextElement *>("read_out");
    QVERIFY(hint->text().startsWith("Wheel"));
    const QImage picture(save("plot.png"));
    QCOMPARE(picture.width(), 2 * plots().width());
    const QRect place(2 * hint->rect().topLeft(), 2 * hint->rect().size());
    QVERIFY(place.width() > 200 && picture.rect().contains(place)); // the legend is above the curves
    const QColor base = first.palette().color(QPalette::Base);
    for (int y = place.top(); y < place.bottom(); ++y)
        for (int x = place.left(); x < place.right(); ++x) QCOMPARE(picture.pixelColor(x, y), base);
    QVERIFY(hint->realVisibility());
}

void TestWindowSavedPlots::documentHasAllPlots() {
    plots().addPlot(inspector::ui::plotContentOf("energy"));
    m_fixture->window().refresh();
    const QByteArray pdf = support::contentOf(save("plots.pdf"));
    const QRegularExpressionMatch box =
        QRegularExpression("/MediaBox \\[0 0 ([0-9.]+) ([0-9.]+)\\]").match(QString::fromLatin1(pdf));
    QVERIFY2(box.hasMatch(), pdf.left(400).constData());
    QCOMPARE(qRound(box.captured(1).toDouble()), plots().width());
    QVERIFY(qRound(box.captured(2).toDouble()) >= plots().height());
}

// That of its numbers: "/F7 12 Tf" selects a font of 12 pixels.
void TestWindowSavedPlots::textsOfADocumentAreAsLargeAsOnTheScreen() {
    const QByteArray pdf = support::contentOf(save("plot.pdf"));
    QRegularExpressionMatchIterator fonts =
        QRegularExpression("/F[0-9]+ ([0-9.]+) Tf").globalMatch(QString::fromLatin1(drawingOf(pdf)));
    QVERIFY(fonts.hasNext());
    const double expected = QFontInfo(plots().first().xAxis->tickLabelFont()).pixelSize();
    while (fonts.hasNext()) QCOMPARE(fonts.next().captured(1).toDouble(), expected);
}

// Where the window leaves the labels out.
void TestWindowSavedPlots::pictureOfLowPlotsHasRoomForTheirLabels() {
    plots().addPlot(inspector::ui::plotContentOf("energy"));
    plots().addPlot(inspector::ui::plotContentOf("position_x"));
    m_fixture->window().refresh();
    QCOMPARE(plots().first().xAxis->label(), QString());
    const QImage picture(save("plots.png"));
    QVERIFY2(picture.height() >= 2 * 3 * 240, qPrintable(QString::number(picture.height())));
    const QColor base = plots().palette().color(QPalette::Base);
    const int bottom = picture.height() - 2 * plots().fontMetrics().height();
    bool hasLabel = false;
    for (int y = bottom; y < picture.height(); ++y)
        for (int x = picture.width() / 2 - 60; x < picture.width() / 2 + 60; ++x)
            hasLabel = hasLabel || picture.pixelColor(x, y) != base;
    QVERIFY(hasLabel);
    QCOMPARE(plots().first().xAxis->label(), QString()); // the window is as before
}

QTEST_MAIN(TestWindowSavedPlots)
#include "tst_window_saved_plots.moc"
