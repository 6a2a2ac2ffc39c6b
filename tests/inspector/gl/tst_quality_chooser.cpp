// SPDX-License-Identifier: MIT
// Which quality is drawn in time, by the pictures' drawing times.
#include "gl/view/quality_chooser.h"

#include <QTest>

using namespace inspector::gl;

namespace {

constexpr int kEnough = 8; // pictures

void note(QualityChooser &chooser, double milliseconds) {
    for (int i = 0; i < kEnough; ++i) chooser.note(milliseconds);
}

} // namespace

class TestQualityChooser : public QObject {
    Q_OBJECT

private slots:
    void slowPicturesLowerIt();
    void lowestStays();
    void fastPicturesRaiseIt();
    void picturesInTimeKeepIt();
    void pictureInTimeAmongSlowOnesKeepsIt();
    void slowerPictureAmongFastOnesKeepsIt();
    void whatWasTooSlowIsNotTriedAgain();
};

void TestQualityChooser::slowPicturesLowerIt() {
    QualityChooser chooser(Quality::High);
    note(chooser, 30.0);
    QCOMPARE(chooser.quality(), Quality::Medium);
    note(chooser, 20.0);
    QCOMPARE(chooser.quality(), Quality::Low);
}

void TestQualityChooser::lowestStays() {
    QualityChooser chooser(Quality::Low);
    note(chooser, 100.0);
    QCOMPARE(chooser.quality(), Quality::Low);
}

void TestQualityChooser::fastPicturesRaiseIt() {
    QualityChooser chooser(Quality::Medium);
    note(chooser, 1.0);
    QCOMPARE(chooser.quality(), Quality::High);
    note(chooser, 1.0);
    QCOMPARE(chooser.quality(), Quality::High);
}

void TestQualityChooser::picturesInTimeKeepIt() {
    QualityChooser chooser(Quality::Medium);
    note(chooser, 10.0);
    QCOMPARE(chooser.quality(), Quality::Medium);
}

void TestQualityChooser::pictureInTimeAmongSlowOnesKeepsIt() {
    QualityChooser chooser(Quality::High);
    for (int i = 0; i < 10 * kEnough; ++i) chooser.note(i % kEnough == 0 ? 10.0 : 500.0);
    QCOMPARE(chooser.quality(), Quality::High);
}

void TestQualityChooser::slowerPictureAmongFastOnesKeepsIt() {
    QualityChooser chooser(Quality::Low);
    for (int i = 0; i < 10 * kEnough; ++i) chooser.note(i % kEnough == 0 ? 10.0 : 1.0);
    QCOMPARE(chooser.quality(), Quality::Low);
}

void TestQualityChooser::whatWasTooSlowIsNotTriedAgain() {
    QualityChooser chooser(Quality::High);
    note(chooser, 30.0);
    note(chooser, 1.0);
    QCOMPARE(chooser.quality(), Quality::Medium);
}

QTEST_APPLESS_MAIN(TestQualityChooser)
#include "tst_quality_chooser.moc"
