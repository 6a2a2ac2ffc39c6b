// SPDX-License-Identifier: MIT
// Files of any name and kind: which are read, which are refused, and that every lost byte is reported.
#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

using namespace inspector;

class TestFiles : public QObject {
    Q_OBJECT

private slots:
    void init();

    void anyBytesMakeANameAndComeBack_data();
    void anyBytesMakeANameAndComeBack();
    void namesThatAreNotUtf8AreReadAndWritten();
    void onlyRegularFilesAreRead_data();
    void onlyRegularFilesAreRead();
    void largeFilesAreRefused();
    void namesAreShownInOneLine_data();
    void namesAreShownInOneLine();

    void whatIsThereStaysUntilTheFirstByte();
    void aFileMadeForNothingIsRemoved();
    void onlyOnesOwnKindIsReplacedUnlessForced();
    void namesThatCantBeWrittenAreToldAtOnce_data();
    void namesThatCantBeWrittenAreToldAtOnce();
    void aSecondWriterIsRefused();
    void aFullDiskIsTold();
    void aClosedPipeIsToldApart();

private:
    QString in(const QString &name) const { return m_folder->filePath(name); }
    void put(const QString &name, const QByteArray &bytes) const {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestFiles::init() { m_folder = std::make_unique<QTemporaryDir>(); }

void TestFiles::anyBytesMakeANameAndComeBack_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("ASCII") << QByteArray("/a/b.txt");
    QTest::newRow("UTF-8 of one to four bytes") << QByteArray("a\xc3\xa4\xe2\x82\xac\xf0\x9f\x8e\xb1z");
    QTest::newRow("Latin 1") << QByteArray("h\xf6he.txt");
    QTest::newRow("cut off") << QByteArray("x\xe2\x82");
    QTest::newRow("surrogate written as UTF-8") << QByteArray("\xed\xb3\xbf");
    QTest::newRow("longer than need be") << QByteArray("\xc0\xaf");
    QTest::newRow("replacement character") << QByteArray("\xef\xbf\xbd");
    QTest::newRow("line break") << QByteArray("a\nb");
    QByteArray all;
    for (int i = 1; i < 256; ++i) all += char(i);
    QTest::newRow("all bytes") << all;
}

void TestFiles::anyBytesMakeANameAndComeBack() {
    QFETCH(QByteArray, bytes);
    QCOMPARE(encodePath(decodePath(bytes)), bytes);
}

void TestFiles::namesThatAreNotUtf8AreReadAndWritten() {
    const QString name = in(decodePath("h\xf6he\n.txt"));
    const auto file = OutputFile::open(name, Existing::Keep, {}, nullptr);
    QVERIFY(file && file->write("7") == 1 && file->finish());
    QCOMPARE(readFile(name, 10, nullptr), QByteArray("7"));
    QVERIFY(fileExists(name));
    QVERIFY(fileNamesIn(m_folder->path()).contains(decodePath("h\xf6he\n.txt")));
    ::unlink(encodePath(name).constData()); // Qt can't
}

void TestFiles::onlyRegularFilesAreRead_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("folder") << "folder"
                            << "expected a file, found a folder";
    QTest::newRow("pipe") << "pipe"
                          << "expected a file, found a pipe";
    QTest::newRow("socket") << "socket"
                            << "expected a file, found a socket";
    QTest::newRow("device") << "/dev/zero"
                            << "expected a file, found a device";
    QTest::newRow("nothing") << "none"
                             << "No such file or directory";
    QTest::newRow("below a file") << "file/x"
                                  << "Not a directory";
    QTest::newRow("loop of links") << "loop"
                                   << "Too many levels of symbolic links";
    QTest::newRow("too long") << QString(300, 'n') << "File name too long";
}

void TestFiles::onlyRegularFilesAreRead() {
    QFETCH(QString, name);
    QFETCH(QString, reason);
    const QString path = name.startsWith('/') ? name : in(name);
    put("file", "x");
    QVERIFY(QDir(m_folder->path()).mkdir("folder"));
    QCOMPARE(::mkfifo(encodePath(in("pipe")).constData(), 0600), 0);
    QCOMPARE(::symlink("loop", encodePath(in("loop")).constData()), 0);
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    qstrncpy(address.sun_path, encodePath(in("socket")).constData(), sizeof address.sun_path);
    QCOMPARE(::bind(socket, reinterpret_cast<const sockaddr *>(&address), sizeof address), 0);
    QString error;
    QVERIFY(!readFile(path, 100, &error));
    ::close(socket);
    QCOMPARE(error, quoted(path) + ": " + reason);
    QVERIFY(beginningOf(path, 10).isEmpty());
}

void TestFiles::largeFilesAreRefused() {
    put("file", QByteArray(2'000'001, 'x'));
    QString error;
    QVERIFY(!readFile(in("file"), 2 * kMegabyte, &error));
    QCOMPARE(error, quoted(in("file")) + ": expected a file of at most 2 MB, found a larger one");
    QVERIFY(readFile(in("file"), 2 * kMegabyte + 1, &error));
}

void TestFiles::namesAreShownInOneLine_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("shown");
    QTest::newRow("plain") << "höhe 1.txt"
                           << "'höhe 1.txt'";
    QTest::newRow("line breaks") << "a\nb\r\tc"
                                 << "'a\\nb\\r\\tc'";
    QTest::newRow("escape sequence") << "\x1b[2Jx"
                                     << "'\\x1b[2Jx'";
    QTest::newRow("turned round") << QStringLiteral("\u202etxt") << "'\\u202etxt'";
    QTest::newRow("line separator") << QStringLiteral("a\u2028b") << "'a\\u2028b'";
    QTest::newRow("not UTF-8") << decodePath("h\xf6he") << "'h\\xf6he'";
    QTest::newRow("letters by chance") << decodePath("h\xc3\xb6he \xff\xd8\xa8") << "'höhe \\xff\\u0628'";
    QTest::newRow("beyond 16 bits") << QStringLiteral("\U0001f3b1") << QStringLiteral("'\U0001f3b1'");
}

void TestFiles::namesAreShownInOneLine() {
    QFETCH(QString, name);
    QFETCH(QString, shown);
    QCOMPARE(quoted(name), shown);
}

void TestFiles::whatIsThereStaysUntilTheFirstByte() {
    put("file", "old and long");
    {
        const auto file = OutputFile::open(in("file"), Existing::Replace, {}, nullptr);
        QVERIFY(file);
        QCOMPARE(readFile(in("file"), 100, nullptr), QByteArray("old and long"));
    }
    QCOMPARE(readFile(in("file"), 100, nullptr), QByteArray("old and long"));
    const auto file = OutputFile::open(in("file"), Existing::Replace, {}, nullptr);
    QVERIFY(file->write("new") == 3 && file->finish());
    QCOMPARE(readFile(in("file"), 100, nullptr), QByteArray("new"));
}

void TestFiles::aFileMadeForNothingIsRemoved() {
    OutputFile::open(in("file"), Existing::Keep, {}, nullptr).reset();
    QVERIFY(!fileExists(in("file")));
}

void TestFiles::onlyOnesOwnKindIsReplacedUnlessForced() {
    put("own", "# table\n1,2\n");
    put("other", "my thesis");
    put("empty", "");
    QString error;
    QVERIFY(OutputFile::open(in("own"), Existing::ReplaceOwn, "# table", &error));
    QVERIFY(OutputFile::open(in("empty"), Existing::ReplaceOwn, "# table", &error));
    QVERIFY(!OutputFile::open(in("other"), Existing::ReplaceOwn, "# table", &error));
    QCOMPARE(error, quoted(in("other")) + ": there is a file of this name already; --force replaces it");
    QVERIFY(!OutputFile::open(in("own"), Existing::Keep, {}, &error));
    QVERIFY(OutputFile::open(in("other"), Existing::Replace, {}, &error));
    QCOMPARE(readFile(in("other"), 100, nullptr), QByteArray("my thesis"));
}

void TestFiles::namesThatCantBeWrittenAreToldAtOnce_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no such folder") << "none/file"
                                    << "No such file or directory";
    QTest::newRow("folder") << "folder"
                            << "Is a directory";
    QTest::newRow("pipe without a reader") << "pipe"
                                           << "No such device or address";
    QTest::newRow("no name") << ""
                             << "No such file or directory";
}

void TestFiles::namesThatCantBeWrittenAreToldAtOnce() {
    QFETCH(QString, name);
    QFETCH(QString, reason);
    QVERIFY(QDir(m_folder->path()).mkdir("folder"));
    QCOMPARE(::mkfifo(encodePath(in("pipe")).constData(), 0600), 0);
    const QString path = name.isEmpty() ? name : in(name);
    QString error;
    QVERIFY(!OutputFile::open(path, Existing::Replace, {}, &error));
    QCOMPARE(error, quoted(path) + ": " + reason);
}

void TestFiles::aSecondWriterIsRefused() {
    const auto first = OutputFile::open(in("file"), Existing::Replace, {}, nullptr);
    QString error;
    QVERIFY(!OutputFile::open(in("file"), Existing::Replace, {}, &error));
    QCOMPARE(error, quoted(in("file")) + ": another program is writing to it");
}

void TestFiles::aFullDiskIsTold() {
    for (const qsizetype size : {qsizetype(1), qsizetype(1'000'000)}) { // short: only the end tells
        const auto file = OutputFile::open("/dev/full", Existing::Replace, {}, nullptr);
        QVERIFY(file);
        file->write(QByteArray(size, 'x'));
        QVERIFY(!file->finish());
        QCOMPARE(file->problem(), QString("'/dev/full': No space left on device"));
        QVERIFY(!file->isUnread());
    }
}

void TestFiles::aClosedPipeIsToldApart() {
    ::signal(SIGPIPE, SIG_IGN); // NOLINT(cert-err33-c)
    int ends[2];
    QCOMPARE(::pipe(ends), 0);
    ::close(ends[0]);
    OutputFile file(ends[1], "standard output");
    file.write("x");
    QVERIFY(!file.finish() && file.isUnread());
    ::close(ends[1]);
}

QTEST_GUILESS_MAIN(TestFiles)
#include "tst_files.moc"
