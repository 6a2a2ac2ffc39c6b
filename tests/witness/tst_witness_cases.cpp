// SPDX-License-Identifier: MIT
// Scenes that once failed, shrunk: every stepper keeps every invariant in each, or the check that it names.
#include <QDirIterator>
#include <QTest>

#include "judge.h"
#include "survey.h"

class WitnessCases : public QObject {
    Q_OBJECT

private slots:
    void aCaseHolds_data();
    void aCaseHolds();
};

void WitnessCases::aCaseHolds_data() {
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("stepper");
    QDirIterator files(WITNESS_FOLDER "/seeds", {"*.case"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QByteArray path = files.next().toUtf8();
        for (const std::string &stepper : witness::stepperIds(nullptr)) {
            const QByteArray tag = files.fileName().toUtf8() + ", " + stepper.c_str();
            QTest::newRow(tag.constData()) << path << QByteArray(stepper.c_str());
        }
    }
}

void WitnessCases::aCaseHolds() {
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, stepper);
    for (const witness::Case &scene : witness::readCases(path.toStdString())) {
        const bool hasToEnd = scene.check == "ends";
        if (hasToEnd && scene.stepper != stepper.toStdString()) continue;
        const witness::Verdict verdict = witness::judge(nullptr, stepper.toStdString(), scene);
        QVERIFY2(verdict.check.empty(), (scene.name + ": " + verdict.check + ": " + verdict.what).c_str());
        if (hasToEnd) QVERIFY2(verdict.status == PHYS_OK, (scene.name + ": " + verdict.statusText).c_str());
    }
}

QTEST_GUILESS_MAIN(WitnessCases)
#include "tst_witness_cases.moc"
