// SPDX-License-Identifier: MIT
// Plugins that end the process that loads them: damaged headers, constructors that crash, exit or hang.
#include "inspector/program/process_run.h"
#include "support/files.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <link.h>

#include <cstring>

using namespace inspector;

class TestDamagedPlugins : public QObject {
    Q_OBJECT

private slots:
    void aFlippedByteOfTheHeadersIsNoMatterOrRefusedInOneLine();
    void oneThatEndsTheProcessIsRefusedInOneLine_data();
    void oneThatEndsTheProcessIsRefusedInOneLine();
    void oneOfAPluginFolderIsLeftOut();
    void whatOnePrintsWhileItIsTriedIsNotSeen();
    void reportCardOfOneIsOneLine();
};

namespace {

Ended tryPlugin(const QString &program, const QStringList &arguments, const QString &variable = {},
                const QString &value = {}) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("PHYS_PLUGIN_PATH");
    if (!variable.isEmpty()) environment.insert(variable, value);
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    return endOf(process);
}

const QStringList kStep{"--headless", "--duration", "0.01", "--stepper", "adaptive-drag", "--csv", "/dev/null"};

// A part of a file.
struct Part {
    qsizetype begin, end;
};

// The file's header, those of its segments, and what the system's loader reads to link it.
std::vector<Part> headersOf(const QByteArray &file) {
    ElfW(Ehdr) header;
    std::memcpy(&header, file.constData(), sizeof header);
    std::vector<Part> parts{{0, qsizetype(header.e_phoff + header.e_phnum * sizeof(ElfW(Phdr)))}};
    for (int i = 0; i < header.e_phnum; ++i) {
        ElfW(Phdr) segment;
        std::memcpy(&segment, file.constData() + header.e_phoff + size_t(i) * sizeof segment, sizeof segment);
        if (segment.p_type != PT_DYNAMIC) continue;
        parts.push_back({qsizetype(segment.p_offset), qsizetype(segment.p_offset + segment.p_filesz)});
    }
    return parts;
}

// A file with the program headers of another file whose first segment is missing.
QByteArray damaged() {
    QByteArray file = support::contentOf(ADAPTIVE_DRAG);
    qsizetype type = sizeof(ElfW(Ehdr)) + offsetof(ElfW(Phdr), p_type);
    while (file[type] != PT_LOAD) type += sizeof(ElfW(Phdr)); // linkers differ in what they put before it
    file[type] ^= char(0x7f);
    return file;
}

} // namespace

void TestDamagedPlugins::aFlippedByteOfTheHeadersIsNoMatterOrRefusedInOneLine() {
    const QTemporaryDir folder;
    const QByteArray whole = support::contentOf(ADAPTIVE_DRAG);
    int loaded = 0, refused = 0, ended = 0;
    for (const Part &part : headersOf(whole)) {
        for (qsizetype at = part.begin; at < part.end; at += 7) {
            const QString path = folder.filePath(QString("%1.so").arg(at));
            QByteArray file = whole;
            file[at] = char(~file[at]);
            support::write(path, file);
            const Ended result = tryPlugin(INSPECTOR, kStep + QStringList{"--plugin", path});
            const QByteArray where = QByteArray::number(at) + ": " + result.messages;
            if (result.status == 0) {
                QVERIFY2(result.messages.startsWith("level 01 not won"), where.constData());
                ++loaded;
                continue;
            }
            QVERIFY2(result.status == 2 && isOneLine(result.messages), where.constData());
            QVERIFY2(result.messages.contains(path.toUtf8()), where.constData());
            ++(result.messages.contains(": loading it ends a process ") ? ended : refused);
        }
    }
    QVERIFY2(loaded > 0 && refused > 0 && ended > 0,
             qPrintable(QString("%1 loaded, %2 refused, %3 ended").arg(loaded).arg(refused).arg(ended)));
}

void TestDamagedPlugins::oneThatEndsTheProcessIsRefusedInOneLine_data() {
    QTest::addColumn<QString>("how");
    QTest::addColumn<QString>("reason");
    QTest::newRow("abort") << "abort"
                           << "ends a process by signal 6, Aborted";
    QTest::newRow("kill") << "kill"
                          << "ends a process by signal 9, Killed";
    QTest::newRow("exit") << "exit"
                          << "ends a process with status 0";
    QTest::newRow("hang") << "hang"
                          << "doesn't end within 10 s";
    QTest::newRow("abort at the end") << "abort at the end"
                                      << "ends a process by signal 6, Aborted";
}

void TestDamagedPlugins::oneThatEndsTheProcessIsRefusedInOneLine() {
    QFETCH(QString, how);
    QFETCH(QString, reason);
    const Ended result = tryPlugin(INSPECTOR, {"--headless", "--duration", "0.01", "--plugin", ENDING}, "ENDING", how);
    QCOMPARE(result.status, 2);
    QCOMPARE(QString(result.messages),
             QString("physics-inspector: --plugin: '" ENDING "': loading it %1\n").arg(reason));
}

void TestDamagedPlugins::oneOfAPluginFolderIsLeftOut() {
    const QTemporaryDir folder;
    support::write(folder.filePath("a.so"), damaged());
    QVERIFY(QFile::copy(ADAPTIVE_DRAG, folder.filePath("b.so")));
    const Ended result = tryPlugin(INSPECTOR, kStep, "PHYS_PLUGIN_PATH", folder.path());
    QCOMPARE(result.status, 0);
    const QByteArray line = "physics-inspector: plugin left out: '" + folder.filePath("a.so").toUtf8();
    QVERIFY2(result.messages.startsWith(line + "': loading it ends a process "), result.messages.constData());
    QCOMPARE(result.messages.count("left out"), 1);
}

void TestDamagedPlugins::whatOnePrintsWhileItIsTriedIsNotSeen() {
    const Ended result = tryPlugin(INSPECTOR, {"--list-steppers", "--plugin", ENDING}, "ENDING", "print");
    QCOMPARE(result.status, 2); // it has no stepper
    QVERIFY2(result.out.isEmpty() && isOneLine(result.messages), result.out + result.messages);
    QVERIFY2(result.messages.contains("expected the symbol phys_plugin_entry; found none"), result.messages);
}

void TestDamagedPlugins::reportCardOfOneIsOneLine() {
    const Ended result = tryPlugin(PHYSICS_CHECK, {ENDING}, "ENDING", "abort");
    QCOMPARE(result.status, 2);
    QCOMPARE(result.messages, QByteArray("physics-check: " ENDING ": crashes: Aborted\n"));
    QVERIFY(result.out.isEmpty());
}

QTEST_GUILESS_MAIN(TestDamagedPlugins)
#include "tst_damaged_plugins.moc"
