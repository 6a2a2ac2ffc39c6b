// SPDX-License-Identifier: GPL-3.0-or-later
// Access to files by any name that the system allows. Only regular files of limited size are read, so that a wrong name
// (of a device, of a pipe without a writer) can't hang the program or fill the memory. Writing reports every lost byte
// and replaces only what may be replaced.
#pragma once

#include <QByteArray>
#include <QIODevice>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

namespace inspector {

// ---- names ----

/// Convert a file's name from and to the system's bytes. Bytes that aren't UTF-8 are kept as lone surrogates (0xdc00 +
/// byte); such names can be opened by the functions here, but not by Qt's.
QString decodePath(const QByteArray &bytes);
QByteArray encodePath(const QString &path);

bool fileExists(const QString &path);
bool isFolder(const QString &path);
/// Names of the files in a folder, without hidden ones, in no particular order. Empty if the folder can't be read.
QStringList fileNamesIn(const QString &folder);
/// Whether two paths lead to the same existing file.
bool isSameFile(const QString &a, const QString &b);

// ---- reading ----

inline constexpr qint64 kMegabyte = 1'000'000;
inline constexpr qint64 kLargestMaze = 200 * kMegabyte; ///< a million boxes

/// All bytes. Returns nothing, with one line in `error` (may be nullptr) that begins with the name, if it is not a
/// regular file, is larger than `limit` bytes, or can't be read.
std::optional<QByteArray> readFile(const QString &path, qint64 limit, QString *error);
/// The first bytes, at most `count`; empty for what readFile() refuses.
QByteArray beginningOf(const QString &path, qint64 count);

// ---- writing ----

/// What to do with a file that exists already.
enum class Existing {
    Replace,    ///< overwrite it, whatever it is
    ReplaceOwn, ///< overwrite it if it is empty or begins with the mark; otherwise refuse the name
    Keep,       ///< refuse the name
};

/// Writes through a buffer. An existing file stays intact until the first byte is written, and a new file to which
/// nothing was written is removed.
class OutputFile : public QIODevice {
public:
    /// Opens the file, so that an unusable name is reported before anything runs. Null, with one line in `error` that
    /// begins with the name, if it can't be written to or if another program is writing to it. mark: the first bytes of
    /// this kind of file, for Existing::ReplaceOwn.
    static std::unique_ptr<OutputFile> open(const QString &path, Existing existing, const QByteArray &mark,
                                            QString *error);
    /// Writes to an open descriptor; 1 is standard output and stays open. name: for messages.
    OutputFile(int descriptor, const QString &name);
    ~OutputFile() override; ///< writes what is left
    OutputFile(const OutputFile &) = delete;
    OutputFile &operator=(const OutputFile &) = delete;

    QString name() const { return m_name; }
    bool isRegular() const { return m_isRegular; } ///< not a device or a pipe
    bool isSequential() const override { return true; }

    /// Hands all bytes to the system. False from the first loss on.
    bool flush();
    /// Flushes, and closes the file.
    bool finish();
    /// Why bytes were lost, in one line that begins with the name; empty if none were lost.
    QString problem() const;
    /// Whether they were lost because the reader has closed the pipe, which isn't an error.
    bool isUnread() const;

protected:
    qint64 readData(char *, qint64) override { return -1; }
    qint64 writeData(const char *data, qint64 size) override;

private:
    void begin();

    QString m_name;
    int m_descriptor;     ///< -1 once it is finished
    bool m_isOwn = false; ///< this object closes it
    bool m_isNew = false; ///< the file was created here
    bool m_isRegular = false;
    bool m_hasBegun = false; ///< something was written
    QByteArray m_waiting;
    int m_failure = 0; ///< errno of the first write that failed
};

/// Writes a file whole or not at all: until everything is on the disk, the old content stays. write: returns false on
/// failure. Returns false, with one line in `error` (may be nullptr) that begins with the name, if anything was lost.
bool replaceFile(const QString &path, const std::function<bool(QIODevice &file)> &write, QString *error);
bool replaceFile(const QString &path, const QByteArray &bytes, QString *error);

/// An output to descriptor 1.
std::unique_ptr<OutputFile> standardOutput();

} // namespace inspector
