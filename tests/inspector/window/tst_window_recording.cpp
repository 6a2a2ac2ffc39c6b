// SPDX-License-Identifier: MIT
// Recording from the menu: asks for a name, is checked while it lasts, ends by the same entry, reports failures.
#include "core/recording/recording.h"
#include "ui/parts/message_bar.h"
#include "window_fixture.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>

#include <memory>

using namespace window_test;

class TestWindowRecording : public WindowSuite {
    Q_OBJECT

private slots:
    void menuRecordsUntilItIsChosenAgain();
    void cancelRecordsNothing();
    void failureIsShownAndUnticked();

private:
    QFileDialog *askedForName();
};

QFileDialog *TestWindowRecording::askedForName() {
    m_fixture->trigger("record");
    return m_fixture->window().findChild<QFileDialog *>();
}

void TestWindowRecording::menuRecordsUntilItIsChosenAgain() {
    const QString file = m_fixture->path("chosen.rec");
    auto *record = m_fixture->find<QAction>("record");
    QFileDialog *dialog = askedForName();
    QVERIFY(dialog && !record->isChecked());
    dialog->findChild<QLineEdit *>("fileNameEdit")->setText(file);
    click(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Save));
    QTRY_VERIFY(record->isChecked());
    m_fixture->trigger("step");
    QTRY_COMPARE(m_fixture->simulation().latest().current.step, uint64_t(1));
    m_fixture->trigger("record");
    QVERIFY(!record->isChecked());
    const auto isWhole = [&] {
        const auto recording = inspector::readRecording(file, m_fixture->session().registry(), nullptr);
        return recording && recording->isWhole && recording->segments.size() == 1 &&
               recording->segments[0].hashes.size() == 1;
    };
    QTRY_VERIFY(isWhole());
}

void TestWindowRecording::cancelRecordsNothing() {
    QFileDialog *dialog = askedForName();
    QVERIFY(dialog);
    click(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Cancel));
    QVERIFY(!m_fixture->find<QAction>("record")->isChecked());
    QVERIFY(!m_fixture->session().isRecording());
}

void TestWindowRecording::failureIsShownAndUnticked() {
    m_fixture->session().startRecording(m_fixture->path("missing/run.rec"));
    auto *bar = m_fixture->window().findChild<inspector::ui::MessageBar *>();
    QTRY_VERIFY(bar->line().contains("missing/run.rec"));
    QVERIFY(!m_fixture->find<QAction>("record")->isChecked());
}

QTEST_MAIN(TestWindowRecording)
#include "tst_window_recording.moc"
