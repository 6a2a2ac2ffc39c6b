// SPDX-License-Identifier: MIT
// Small files that a test reads and writes as a whole; failures end the test program.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

namespace support {

inline QByteArray contentOf(const QString &path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) qFatal("%s isn't there", qPrintable(path));
    return file.readAll();
}

inline void write(const QString &path, const QByteArray &content) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("%s can't be written", qPrintable(path));
}

} // namespace support
