// SPDX-License-Identifier: GPL-3.0-or-later
// Files by any name that the system allows. Reading takes regular files of a bounded size only, so that nothing named
// by mistake (a device, a pipe without a writer) hangs the program or fills the memory; writing tells every byte that
// is lost, and replaces nothing but what it may.
#pragma once

#include <QByteArray>
#include <QIODevice>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

namespace inspector {

// ---- names ----

// Of a file, from and to the system's bytes. Bytes that aren't UTF-8 are kept as lone surrogates (0xdc00 + byte): such
// names are opened by the functions here and by nothing of Qt.
QString decodePath(const QByteArray &bytes);
QByteArray encodePath(const QString &path);

bool fileExists(const QString &path);
bool isFolder(const QString &path);
// Names of the files of a folder, without those that begin with a point; in no order. Empty if it can't be read.
QStringList fileNamesIn(const QString &folder);
// Whether two paths lead to one file that is there.
bool isSameFile(const QString &a, const QString &b);

// ---- reading ----

inline constexpr qint64 kMegabyte = 1'000'000;
inline constexpr qint64 kLargestMaze = 200 * kMegabyte; // a million boxes

// All bytes. Nothing, and one line in `error` (or nullptr) that begins with the name, for what is no regular file, is
// larger than `limit` bytes, or can't be read.
std::optional<QByteArray> readFile(const QString &path, qint64 limit, QString *error);
// The first bytes, at most `count`; empty for what readFile() refuses.
QByteArray beginningOf(const QString &path, qint64 count);

// ---- writing ----

// What becomes of a file that is there already.
enum class Existing {
    Replace,    // whatever it is
    ReplaceOwn, // if it is empty or begins as what is to be written; else the name is refused
    Keep,       // the name is refused
};

// Writes through a buffer. Nothing of a file that is there is lost before the first byte is written, and a file made
// for nothing is removed.
class OutputFile : public QIODevice {
public:
    // Opens it, so that a name that can't be written to is told before anything runs. Null, and one line in `error`
    // that begins with the name, if it can't, or if another program is writing to it. mark: how one's own kind of file
    // begins, for Existing::ReplaceOwn.
    static std::unique_ptr<OutputFile> open(const QString &path, Existing existing, const QByteArray &mark,
                                            QString *error);
    // Of an open descriptor, 1 for standard output, which stays open. name: for messages.
    OutputFile(int descriptor, const QString &name);
    ~OutputFile() override; // writes what is left
    OutputFile(const OutputFile &) = delete;
    OutputFile &operator=(const OutputFile &) = delete;

    QString name() const { return m_name; }
    bool isRegular() const { return m_isRegular; } // no device, no pipe
    bool isSequential() const override { return true; }

    // Hands all bytes to the system. False once something was lost.
    bool flush();
    // The same, and closes the file.
    bool finish();
    // Why bytes were lost, in one line that begins with the name; empty if none were.
    QString problem() const;
    // Whether they were lost because nobody reads any more (a closed pipe), which is no fault.
    bool isUnread() const;

protected:
    qint64 readData(char *, qint64) override { return -1; }
    qint64 writeData(const char *data, qint64 size) override;

private:
    void begin();

    QString m_name;
    int m_descriptor;     // -1 once it is finished
    bool m_isOwn = false; // to be closed
    bool m_isNew = false; // there was none of this name
    bool m_isRegular = false;
    bool m_hasBegun = false; // something was written
    QByteArray m_waiting;
    int m_failure = 0; // errno of the first write that failed
};

// Writes a file whole or not at all: until all of it is on the disk, the name keeps what it had. write: false if it
// can't. False, and one line in `error` (or nullptr) that begins with the name, if anything of it was lost.
bool replaceFile(const QString &path, const std::function<bool(QIODevice &file)> &write, QString *error);
bool replaceFile(const QString &path, const QByteArray &bytes, QString *error);

// Descriptor 1.
std::unique_ptr<OutputFile> standardOutput();

} // namespace inspector
