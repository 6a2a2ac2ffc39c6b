// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/settings_file.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QCoreApplication>
#include <QFileDevice>
#include <QFileInfo>
#include <QLockFile>
#include <QStandardPaths>
#include <QStringList>

#include <algorithm>
#include <optional>

namespace inspector {

namespace {

/// Decodes up to `most` hexadecimal digits at `at`, which is advanced; nothing if there is no digit.
std::optional<QChar> hexadecimal(QStringView text, qsizetype &at, int most) {
    qsizetype end = at;
    const auto isDigit = [](QChar c) { return c.unicode() < 128 && std::isxdigit(c.unicode()); };
    while (end < text.size() && end - at < most && isDigit(text[end])) ++end;
    if (end == at) return std::nullopt;
    const QStringView digits = text.sliced(at, end - at);
    at = end;
    return QChar(digits.toUShort(nullptr, 16));
}

QString padded(ushort code, int digits) { return QString::number(code, 16).rightJustified(digits, QLatin1Char('0')); }

// ---- keys ----

QString decodeKey(QStringView text) {
    QString key;
    for (qsizetype i = 0; i < text.size();) {
        const QChar c = text[i++];
        const bool isWide = c == QLatin1Char('%') && i < text.size() && text[i] == QLatin1Char('U');
        qsizetype digits = isWide ? i + 1 : i;
        const std::optional<QChar> named =
            c == QLatin1Char('%') ? hexadecimal(text, digits, isWide ? 4 : 2) : std::nullopt;
        if (named) i = digits;
        key += named.value_or(c == QLatin1Char('\\') ? QLatin1Char('/') : c);
    }
    return key;
}

QString encodeKey(const QString &key) {
    QString text;
    for (const QChar c : key) {
        const ushort code = c.unicode();
        const bool isPlain = code < 128 && (std::isalnum(code) || QStringView(u"_-./").contains(c));
        if (isPlain)
            text += c;
        else
            text += code < 256 ? QLatin1Char('%') + padded(code, 2) : QStringLiteral("%U") + padded(code, 4);
    }
    return text;
}

const QString kNowhere = QStringLiteral("/dev/null/settings"); ///< can't be opened

QString usualFile() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + QLatin1Char('/') +
           QCoreApplication::organizationName() + QLatin1Char('/') + QCoreApplication::applicationName() +
           QStringLiteral(".conf");
}

// ---- values ----

/// Decodes the escape after a backslash at `at`, which is advanced.
QChar escaped(QStringView text, qsizetype &at) {
    const QChar c = text[at++];
    switch (c.unicode()) {
    case 'n':
        return QLatin1Char('\n');
    case 'r':
        return QLatin1Char('\r');
    case 't':
        return QLatin1Char('\t');
    case 'x':
        return hexadecimal(text, at, 4).value_or(c);
    default:
        return c;
    }
}

/// The items of a list: quoted, or unquoted up to a comma. No items: an empty list.
QStringList itemsOf(QStringView text) {
    if (text.trimmed().isEmpty()) return {};
    QStringList items;
    QString item;
    bool isInQuotes = false, wasInQuotes = false;
    const auto finish = [&] {
        items += wasInQuotes ? item : item.trimmed();
        item.clear();
        wasInQuotes = false;
    };
    for (qsizetype i = 0; i < text.size();) {
        const QChar c = text[i++];
        if (c == QLatin1Char('"')) {
            isInQuotes = !isInQuotes;
            if (isInQuotes) item.clear(); // skip leading spaces
            wasInQuotes = true;
        } else if (c == QLatin1Char(',') && !isInQuotes) {
            finish();
        } else if (c == QLatin1Char('\\') && i < text.size()) {
            item += escaped(text, i);
        } else if (isInQuotes || !wasInQuotes) { // ignore trailing spaces
            item += c;
        }
    }
    finish();
    return items;
}

/// Returns nothing for values in Qt's syntax for objects. In Qt's format an @ at the beginning of a text is doubled.
std::optional<QVariant> decodeValue(QStringView text) {
    QStringList items = itemsOf(text);
    for (QString &item : items) {
        if (!item.startsWith(QLatin1Char('@'))) continue;
        item.remove(0, 1);
        if (!item.startsWith(QLatin1Char('@'))) return std::nullopt;
    }
    return items.size() == 1 ? QVariant(items.front()) : QVariant(items);
}

QString encodeText(const QString &text) {
    QString written(QLatin1Char('"'));
    if (text.startsWith(QLatin1Char('@'))) written += QLatin1Char('@');
    for (const QChar c : text) {
        if (c == QLatin1Char('\\') || c == QLatin1Char('"'))
            written += QLatin1Char('\\') + QString(c);
        else if (c == QLatin1Char('\n'))
            written += QStringLiteral("\\n");
        else if (c.unicode() < ' ' || c.unicode() > '~')
            written += QStringLiteral("\\x") + padded(c.unicode(), 4);
        else
            written += c;
    }
    return written + QLatin1Char('"');
}

QString encodeValue(const QVariant &value) {
    if (value.typeId() != QMetaType::QStringList) return encodeText(value.toString());
    QStringList items = value.toStringList();
    std::transform(items.begin(), items.end(), items.begin(), encodeText);
    return items.join(QStringLiteral(", "));
}

// ---- files ----

bool read(QIODevice &file, QSettings::SettingsMap &settings) {
    const QByteArray bytes = file.read(kMegabyte + 1);
    if (bytes.size() > kMegabyte) return false;
    settings = readSettings(bytes);
    return true;
}

/// QSaveFile doesn't notice a loss while its buffer is written at the end and would put half a file in place.
bool write(QIODevice &file, const QSettings::SettingsMap &settings) {
    const QByteArray bytes = writeSettings(settings);
    auto *saved = qobject_cast<QFileDevice *>(&file);
    return file.write(bytes) == bytes.size() && (!saved || (saved->flush() && saved->size() == bytes.size()));
}

/// Why QSettings would block forever: the file is a pipe, or it has a lock that is never released.
QString reasonAgainst(const QString &path) {
    const QString lockPath = path + QStringLiteral(".lock");
    for (const QString &name : {path, lockPath}) {
        const QFileInfo info(name);
        if (info.exists() && !info.isFile()) return QStringLiteral("it, or its lock, is no file");
    }
    QLockFile lock(lockPath);
    const bool isHeld = !lock.tryLock(1000) && lock.error() == QLockFile::LockFailedError;
    return isHeld ? QStringLiteral("another program holds its lock") : QString();
}

} // namespace

QSettings::SettingsMap readSettings(const QByteArray &bytes) {
    QSettings::SettingsMap settings;
    QString section;
    const QString text = QString::fromUtf8(bytes);
    for (QStringView line : QStringView(text).split(QLatin1Char('\n'))) {
        line = line.trimmed();
        if (line.startsWith(QLatin1Char('[')) && line.endsWith(QLatin1Char(']'))) {
            const QStringView name = line.sliced(1, line.size() - 2);
            section = name == QLatin1String("General") ? QString() : decodeKey(name) + QLatin1Char('/');
            continue;
        }
        const qsizetype equals = line.indexOf(QLatin1Char('='));
        const bool isComment = line.startsWith(QLatin1Char(';')) || line.startsWith(QLatin1Char('#'));
        if (equals <= 0 || isComment) continue;
        if (const auto value = decodeValue(line.sliced(equals + 1)))
            settings.insert(section + decodeKey(line.first(equals).trimmed()), *value);
    }
    return settings;
}

QByteArray writeSettings(const QSettings::SettingsMap &settings) {
    QByteArray bytes;
    for (auto setting = settings.begin(); setting != settings.end(); ++setting)
        bytes += encodeKey(setting.key()).toLatin1() + '=' + encodeValue(setting.value()).toLatin1() + '\n';
    return bytes;
}

QSettings::Format settingsFormat() {
    static const QSettings::Format format = QSettings::registerFormat(QStringLiteral("conf"), read, write);
    return format;
}

QString userSettingsFile(QString *problem) {
    const QString path = usualFile();
    const QString reason = reasonAgainst(path);
    if (reason.isEmpty()) return path;
    *problem = quoted(path) + QStringLiteral(": settings aren't kept: ") + reason;
    return kNowhere;
}

QString shownFileOf(const QSettings &settings) {
    return settings.fileName() == kNowhere ? usualFile() : settings.fileName();
}

} // namespace inspector
