// SPDX-License-Identifier: MIT
// Every extreme case has its documented outcome, under every stepper and both models: model.md 11.
#include "catalogue.h"

#include "support/stepper_rows.h"

#include <QTest>

using namespace extremes;
using namespace support;

class TestExtremes : public QObject {
    Q_OBJECT

private slots:
    void endsAsDocumented_data();
    void endsAsDocumented();

private:
    const std::vector<Extreme> m_extremes = allExtremes();
};

void TestExtremes::endsAsDocumented_data() {
    QTest::addColumn<int>("extreme");
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<uint32_t>("model");
    for (size_t i = 0; i < m_extremes.size(); ++i) {
        for (const QByteArray &id : stepperIds()) {
            for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
                QTest::addRow("%s: %s, %s", m_extremes[i].name.constData(), id.constData(),
                              modelName(model).constData())
                    << static_cast<int>(i) << id << model;
            }
        }
    }
}

void TestExtremes::endsAsDocumented() {
    QFETCH(int, extreme);
    QFETCH(QByteArray, stepper);
    QFETCH(uint32_t, model);
    const Extreme &row = m_extremes[static_cast<size_t>(extreme)];
    const Outcome outcome = overDraws(row, stepper, model);
    QVERIFY2(outcome.problem.isEmpty(), outcome.problem);
    const QByteArray expected = row.expected(stepper, model);
    QVERIFY2(isExpected(outcome.text, expected), outcome.text + " instead of " + expected);
}

QTEST_GUILESS_MAIN(TestExtremes)
#include "tst_extremes.moc"
