// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/files.h"

#include "core/setup/lines.h"

#include <QSaveFile>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace inspector {

namespace {

constexpr ushort kEscape = 0xdc00; ///< + the byte

QString reasonOf(int failure) { return QString::fromStdString(std::generic_category().message(failure)); }

QString kindOf(mode_t mode) {
    if (S_ISDIR(mode)) return QStringLiteral("a folder");
    if (S_ISFIFO(mode)) return QStringLiteral("a pipe");
    if (S_ISSOCK(mode)) return QStringLiteral("a socket");
    return QStringLiteral("a device");
}

void say(QString *error, const QString &path, const QString &reason) {
    if (error) *error = quoted(path) + QStringLiteral(": ") + reason;
}

void sayTooLarge(QString *error, const QString &path, qint64 limit) {
    say(error, path, QStringLiteral("expected a file of at most %1 MB, found a larger one").arg(limit / kMegabyte));
}

/// Closes a descriptor at the end of its scope; -1: none.
class Descriptor {
public:
    explicit Descriptor(int number)
        : m_number(number) {}
    ~Descriptor() {
        if (m_number >= 0) ::close(m_number);
    }
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;
    int number() const { return m_number; }
    int release() { return std::exchange(m_number, -1); }

private:
    int m_number;
};

/// Opens without blocking: opening a pipe without a writer would block for ever. Devices are not even opened.
int openToRead(const QString &path, qint64 *size, QString *error) {
    const QByteArray name = encodePath(path);
    struct stat info {};
    if (::stat(name.constData(), &info) != 0) {
        say(error, path, reasonOf(errno));
        return -1;
    }
    const auto isRegular = [&] {
        if (S_ISREG(info.st_mode)) return true;
        say(error, path, QStringLiteral("expected a file, found ") + kindOf(info.st_mode));
        return false;
    };
    if (!isRegular()) return -1;
    Descriptor file(::open(name.constData(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (file.number() < 0 || ::fstat(file.number(), &info) != 0) {
        say(error, path, reasonOf(errno));
        return -1;
    }
    if (!isRegular()) return -1; // replaced meanwhile
    *size = info.st_size;
    return file.release();
}

/// Up to `count` bytes; nothing if they can't be read.
std::optional<QByteArray> readUpTo(int descriptor, qint64 count) {
    QByteArray bytes;
    char block[65536];
    while (bytes.size() < count) {
        const auto wanted = size_t(std::min<qint64>(qint64(sizeof block), count - bytes.size()));
        const ssize_t got = ::read(descriptor, block, wanted);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return std::nullopt;
        if (got == 0) break;
        bytes.append(block, got);
    }
    return bytes;
}

} // namespace

QString decodePath(const QByteArray &bytes) {
    QString path;
    for (qsizetype begin = 0; begin < bytes.size();) {
        // The longest prefix that is valid UTF-8 (UTF-8 has no surrogates, so they can mark other bytes unambiguously).
        qsizetype length = std::min<qsizetype>(4, bytes.size() - begin);
        QString character;
        for (; length > 0; --length) {
            character = QString::fromUtf8(bytes.constData() + begin, length);
            const bool isOne = character.size() == 1 || (character.size() == 2 && character[0].isHighSurrogate());
            if (isOne && character.toUtf8() == QByteArrayView(bytes.constData() + begin, length)) break;
        }
        if (length == 0) character = QChar(ushort(kEscape + uint8_t(bytes[begin])));
        path += character;
        begin += std::max<qsizetype>(1, length);
    }
    return path;
}

QByteArray encodePath(const QString &path) {
    QByteArray bytes;
    for (qsizetype i = 0; i < path.size(); ++i) {
        const ushort code = path[i].unicode();
        const bool isPair = path[i].isHighSurrogate() && i + 1 < path.size() && path[i + 1].isLowSurrogate();
        if (isPair)
            bytes += path.mid(i++, 2).toUtf8();
        else if (code >= kEscape + 0x80 && code <= kEscape + 0xff)
            bytes += char(code & 0xff);
        else
            bytes += QString(path[i]).toUtf8();
    }
    return bytes;
}

bool fileExists(const QString &path) {
    struct stat info {};
    return ::stat(encodePath(path).constData(), &info) == 0 && !S_ISDIR(info.st_mode);
}

bool isFolder(const QString &path) {
    struct stat info {};
    return ::stat(encodePath(path).constData(), &info) == 0 && S_ISDIR(info.st_mode);
}

QStringList fileNamesIn(const QString &folder) {
    QStringList names;
    DIR *directory = ::opendir(encodePath(folder).constData());
    if (!directory) return names;
    while (const dirent *entry = ::readdir(directory)) // NOLINT(concurrency-mt-unsafe): a stream of its own
        if (entry->d_name[0] != '.') names += decodePath(entry->d_name);
    ::closedir(directory);
    return names;
}

bool isSameFile(const QString &a, const QString &b) {
    struct stat one {};
    struct stat other {};
    if (::stat(encodePath(a).constData(), &one) != 0 || ::stat(encodePath(b).constData(), &other) != 0) return false;
    return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

std::optional<QByteArray> readFile(const QString &path, qint64 limit, QString *error) {
    qint64 size = 0;
    const Descriptor file(openToRead(path, &size, error));
    if (file.number() < 0) return std::nullopt;
    if (size > limit) return sayTooLarge(error, path, limit), std::nullopt;
    std::optional<QByteArray> bytes = readUpTo(file.number(), limit + 1);
    if (!bytes) return say(error, path, reasonOf(errno)), std::nullopt;
    if (bytes->size() > limit) return sayTooLarge(error, path, limit), std::nullopt; // it is growing, or is in /proc
    return bytes;
}

QByteArray beginningOf(const QString &path, qint64 count) {
    qint64 size = 0;
    const Descriptor file(openToRead(path, &size, nullptr));
    return file.number() < 0 ? QByteArray() : readUpTo(file.number(), count).value_or(QByteArray());
}

namespace {

/// Why the existing file must not be replaced; empty if it may be.
QString refusalOf(int descriptor, Existing existing, const QByteArray &mark) {
    if (existing == Existing::Replace) return {};
    char first[64];
    const ssize_t got = ::pread(descriptor, first, std::min(sizeof first, size_t(mark.size()) + 1), 0);
    if (got == 0) return {};
    const bool isOwn = got > 0 && QByteArrayView(first, got).startsWith(mark) && !mark.isEmpty();
    if (existing == Existing::ReplaceOwn && isOwn) return {};
    return QStringLiteral("there is a file of this name already; --force replaces it");
}

} // namespace

std::unique_ptr<OutputFile> OutputFile::open(const QString &path, Existing existing, const QByteArray &mark,
                                             QString *error) {
    const QByteArray name = encodePath(path);
    const auto refuse = [&](const QString &reason) {
        say(error, path, reason);
        return nullptr;
    };
    // O_RDWR, to look at what is there; O_NONBLOCK: a pipe without a reader is refused instead of waited for.
    constexpr int kFlags = O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    bool isNew = true;
    Descriptor file(::open(name.constData(), O_RDWR | O_CREAT | O_EXCL | kFlags, 0666));
    if (file.number() < 0) {
        if (errno != EEXIST) return refuse(reasonOf(errno));
        isNew = false;
    }
    struct stat info {};
    if (!isNew && ::stat(name.constData(), &info) != 0) return refuse(reasonOf(errno));
    const bool isRegular = isNew || S_ISREG(info.st_mode);
    Descriptor there(isNew ? file.release() : ::open(name.constData(), (isRegular ? O_RDWR : O_WRONLY) | kFlags));
    if (there.number() < 0) return refuse(reasonOf(errno));
    if (isRegular && ::flock(there.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return refuse(QStringLiteral("another program is writing to it"));
    const QString reason = isNew || !isRegular ? QString() : refusalOf(there.number(), existing, mark);
    if (!reason.isEmpty()) return refuse(reason);
    ::fcntl(there.number(), F_SETFL, ::fcntl(there.number(), F_GETFL) & ~O_NONBLOCK);
    auto opened = std::make_unique<OutputFile>(there.release(), path);
    opened->m_isOwn = true;
    opened->m_isNew = isNew;
    opened->m_isRegular = isRegular;
    return opened;
}

OutputFile::OutputFile(int descriptor, const QString &name)
    : m_name(name)
    , m_descriptor(descriptor) {
    QIODevice::open(QIODevice::WriteOnly);
}

OutputFile::~OutputFile() { finish(); }

/// Truncates an existing file when its replacement's first byte is written.
void OutputFile::begin() {
    if (m_hasBegun) return;
    m_hasBegun = true;
    if (m_isRegular && ::ftruncate(m_descriptor, 0) != 0) m_failure = errno;
}

qint64 OutputFile::writeData(const char *data, qint64 size) {
    constexpr qsizetype kBuffer = 65536; // bytes
    if (m_failure || m_descriptor < 0) return -1;
    m_waiting.append(data, size);
    return m_waiting.size() < kBuffer || flush() ? size : -1;
}

bool OutputFile::flush() {
    if (!m_waiting.isEmpty()) begin();
    for (qsizetype written = 0; written < m_waiting.size() && !m_failure;) {
        const ssize_t count =
            ::write(m_descriptor, m_waiting.constData() + written, size_t(m_waiting.size() - written));
        if (count >= 0)
            written += count;
        else if (errno != EINTR)
            m_failure = errno;
    }
    m_waiting.clear();
    if (m_failure) setErrorString(reasonOf(m_failure));
    return !m_failure;
}

bool OutputFile::finish() {
    if (m_descriptor < 0) return !m_failure;
    flush();
    if (m_isOwn) {
        if (m_isNew && !m_hasBegun) ::unlink(encodePath(m_name).constData());
        // Some file systems report only here that the disk is full.
        if (::close(m_descriptor) != 0 && !m_failure) m_failure = errno;
    }
    m_descriptor = -1;
    QIODevice::close();
    return !m_failure;
}

QString OutputFile::problem() const {
    return m_failure ? quoted(m_name) + QStringLiteral(": ") + reasonOf(m_failure) : QString();
}

bool replaceFile(const QString &path, const std::function<bool(QIODevice &file)> &write, QString *error) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        say(error, path, file.errorString());
        return false;
    }
    // commit() doesn't notice a loss while the buffer is written and would put half a file in place. After a short
    // write only errno knows the reason.
    errno = 0;
    const bool isWhole = write(file) && file.flush() && file.error() == QSaveFile::NoError;
    const QString reason = errno ? reasonOf(errno) : file.errorString();
    if (isWhole && file.commit()) return true;
    say(error, path, isWhole ? file.errorString() : reason);
    return false;
}

bool replaceFile(const QString &path, const QByteArray &bytes, QString *error) {
    return replaceFile(
        path, [&](QIODevice &file) { return file.write(bytes) == bytes.size(); }, error);
}

std::unique_ptr<OutputFile> standardOutput() {
    return std::make_unique<OutputFile>(STDOUT_FILENO, QStringLiteral("standard output"));
}

bool OutputFile::isUnread() const { return m_failure == EPIPE; }

} // namespace inspector
