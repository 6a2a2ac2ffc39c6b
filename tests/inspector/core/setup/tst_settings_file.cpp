// SPDX-License-Identifier: MIT
// Whatever bytes a settings file contains, a setting is text or has its default; what is written is read back.
#include "core/setup/settings_file.h"
#include "core/setup/stored_values.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace inspector;

class TestSettingsFile : public QObject {
    Q_OBJECT

private slots:
    void textIsReadBack_data();
    void textIsReadBack();
    void listIsReadBack();
    void keyOfAnyCharactersIsReadBack();
    void bytesAreReadBack();
    void bytesThatArentWholeAreNone();
    void objectOfQtGivesTheDefault_data();
    void objectOfQtGivesTheDefault();
    void lengthThatAValueNamesIsNotAllocated();
    void spoiltLineLeavesTheOthers_data();
    void spoiltLineLeavesTheOthers();
    void fileOfAnEarlierVersionIsRead();
    void tooLargeFileCountsAsEmpty();
    void whatIsNoFileKeepsSettingsWhileTheProgramRuns();
    void twoProgramsKeepEachOthersSettings();

private:
    QString written(const QByteArray &bytes);

    QTemporaryDir m_folder;
};

QString TestSettingsFile::written(const QByteArray &bytes) {
    QString path = m_folder.filePath(QStringLiteral("%1.conf").arg(QTest::currentTestFunction()));
    QFile file(path);
    [&] { QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size()); }();
    return path;
}

void TestSettingsFile::textIsReadBack_data() {
    QTest::addColumn<QString>("text");
    const QString texts[] = {"",
                             " ",
                             "a",
                             "a, b",
                             "\"",
                             "\\",
                             "\\x40",
                             "a\nb\r\n\tc",
                             "[a]=b;#",
                             "@",
                             "@@",
                             "@Invalid()",
                             "@Variant(\\0\\0)",
                             "%40",
                             "\u00e9f",
                             "\u4e2d1",
                             QString(QChar(0)) + "0",
                             QString(QChar(0xdcff)) + "f",
                             "\U0001f600",
                             QString(70000, 'a')};
    for (const QString &text : texts) QTest::addRow("%s", qPrintable(text.left(20))) << text;
}

void TestSettingsFile::textIsReadBack() {
    QFETCH(QString, text);
    const QVariant value = readSettings(writeSettings({{"a/b", text}})).value("a/b");
    QCOMPARE(value.typeId(), int(QMetaType::QString));
    QCOMPARE(value.toString(), text);
}

void TestSettingsFile::listIsReadBack() {
    for (const QStringList &list : {QStringList{}, QStringList{"", ""}, QStringList{"a,", "\"b\"", "@c", " d "}})
        QCOMPARE(readSettings(writeSettings({{"a/b", list}})).value("a/b").toStringList(), list);
}

void TestSettingsFile::keyOfAnyCharactersIsReadBack() {
    for (const QString key :
         {"a", "a/b/c", "a b", "a=b", "@a", "%", "a%20b", "\\", "[a]", ";", "#", "\u00e9", "\u4e2d", "\n"})
        QCOMPARE(readSettings(writeSettings({{key, "1"}})).keys(), QStringList{key});
}

void TestSettingsFile::bytesAreReadBack() {
    QByteArray bytes;
    for (int i = 0; i < 256; ++i) bytes += char(i);
    const QString path = written({});
    {
        QSettings settings(path, settingsFormat());
        storeBytes(settings, "window/layout", bytes);
    }
    const QSettings settings(path, settingsFormat());
    QCOMPARE(storedBytes(settings, "window/layout"), bytes);
}

void TestSettingsFile::bytesThatArentWholeAreNone() {
    const QSettings settings(written("a=AAE?\nb=\"AA E\"\nc=AAEC\nd=\n"), settingsFormat());
    QCOMPARE(storedBytes(settings, "a"), QByteArray());
    QCOMPARE(storedBytes(settings, "b"), QByteArray());
    QCOMPARE(storedBytes(settings, "c"), QByteArray("\0\1\2", 3));
    QCOMPARE(storedBytes(settings, "d"), QByteArray());
}

void TestSettingsFile::objectOfQtGivesTheDefault_data() {
    QTest::addColumn<QByteArray>("value");
    const char *values[] = {
        "@Variant(\\0\\0\\0\\x4\\xff\\xff\\xff\\xff)",
        "@ByteArray(\\x1\\x)",
        "@Rect(0 0 1 1)",
        "@Size(1 1)",
        "@Point(1 1)",
        "@Invalid()",
        "@String(2)",
        "@DateTime(\\0)",
        "@",
        "\"@ByteArray(a, b)\"",
        "\\x40Variant(\\0\\0\\0\\x4)",
        "\"\\x40Invalid()\"",
        "1, @Variant(\\0)",
        "@Invalid(), 1",
    };
    for (const char *value : values) QTest::addRow("%s", value) << QByteArray(value);
}

void TestSettingsFile::objectOfQtGivesTheDefault() {
    QFETCH(QByteArray, value);
    const QSettings settings(written("[window]\nquality=" + value + "\ntheme=1\n"), settingsFormat());
    QVERIFY(!settings.contains("window/quality"));
    QVERIFY(!storedChoice(settings, "window/quality", 3));
    QCOMPARE(storedChoice(settings, "window/theme", 3), 1);
}

void TestSettingsFile::lengthThatAValueNamesIsNotAllocated() {
    const char *file =
        "W3d0aXgwaW5kb3ddCnF1YWxpdHk9Nwp0aGVtZT1AVmFyaWFudChcMFwwXDBcdGl4MHg2XGAyKQpnZW9tZXRyeT1AQnl0ZUFycm"
        "F5KFx4MVx4KQo="; // 56 GB, read by Qt
    const QSettings settings(written(QByteArray::fromBase64(file)), settingsFormat());
    QCOMPARE(settings.allKeys(), QStringList{"wtix0indow/quality"});
}

void TestSettingsFile::spoiltLineLeavesTheOthers_data() {
    QTest::addColumn<QByteArray>("line");
    const char *lines[] = {"",          "theme",         "=1",          "[",   "]",    "[]",     "[window", "window]",
                           "a=\"",      "a=\\",          "a=\\x",       "%=1", "%U=1", "%u12=1", "a=\"\\",  ",=,",
                           "\"\"=\"\"", "\xff\xfe=\xff", "\xef\xbb\xbf"};
    for (const char *line : lines) QTest::addRow("%s", line) << QByteArray(line);
    QTest::newRow("NUL") << QByteArray("\0=\0", 3);
}

void TestSettingsFile::spoiltLineLeavesTheOthers() {
    QFETCH(QByteArray, line);
    const QSettings settings(written("before=1\n" + line + "\n[window]\ntheme=2\n"), settingsFormat());
    QCOMPARE(settings.value("before").toString(), QString("1"));
    QCOMPARE(settings.value("window/theme").toString(), QString("2"));
}

void TestSettingsFile::fileOfAnEarlierVersionIsRead() {
    const QString path = written({});
    const QString set = QStringLiteral("physics-parameters 1\nname \u00e9a \"b\"\nset mass 1\n");
    {
        QSettings qt(path, QSettings::IniFormat);
        qt.setValue("window/geometry", QByteArray("\1\2,\xff", 4));
        qt.setValue("window/theme", 1);
        qt.setValue("window/recent", QStringList{"/a.txt", "/b, c.txt", "/\u00e9.txt"});
        qt.setValue("best_times/3f0c", 7.25);
        qt.setValue("parameter_sets/my%20set", set);
        qt.setValue("window/show_bounces", false);
        qt.setValue("alone", "@a");
    }
    const QSettings settings(path, settingsFormat());
    QCOMPARE(storedBytes(settings, "window/geometry"), QByteArray());
    QCOMPARE(storedChoice(settings, "window/theme", 3), 1);
    QCOMPARE(settings.value("window/recent").toStringList(), (QStringList{"/a.txt", "/b, c.txt", "/\u00e9.txt"}));
    QCOMPARE(storedTime(settings, "best_times/3f0c"), 7.25);
    QCOMPARE(settings.value("parameter_sets/my%20set").toString(), set);
    QCOMPARE(settings.value("window/show_bounces", true).toBool(), false);
    QCOMPARE(settings.value("alone").toString(), QString("@a"));
}

void TestSettingsFile::tooLargeFileCountsAsEmpty() {
    const QString path = written("window/theme=1\n");
    QFile file(path);
    QVERIFY(file.resize(100'000'000));
    QSettings settings(path, settingsFormat());
    QCOMPARE(settings.allKeys(), QStringList());
    settings.setValue("window/theme", 2);
    settings.sync();
    QCOMPARE(QSettings(path, settingsFormat()).value("window/theme").toInt(), 2);
}

void TestSettingsFile::whatIsNoFileKeepsSettingsWhileTheProgramRuns() {
    QSettings settings(m_folder.path(), settingsFormat());
    settings.setValue("window/theme", 2);
    settings.sync();
    QCOMPARE(settings.status(), QSettings::AccessError);
    QCOMPARE(settings.value("window/theme").toInt(), 2);
}

void TestSettingsFile::twoProgramsKeepEachOthersSettings() {
    const QString path = written("a=1\n");
    // Another path to it: QSettings shares what it read between those of one path.
    const QString other = m_folder.filePath("link.conf");
    QVERIFY(QFile::link(path, other));
    QSettings one(path, settingsFormat()), two(other, settingsFormat());
    QCOMPARE(two.value("a").toInt(), 1);
    one.setValue("b", 2);
    one.sync();
    two.setValue("c", 3);
    two.sync();
    one.sync();
    QCOMPARE(one.allKeys(), (QStringList{"a", "b", "c"}));
}

QTEST_GUILESS_MAIN(TestSettingsFile)
#include "tst_settings_file.moc"
