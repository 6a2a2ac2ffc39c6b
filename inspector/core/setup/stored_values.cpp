// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/stored_values.h"

#include <QSettings>

#include <cmath>

namespace inspector {

std::optional<int> storedChoice(const QSettings &settings, const QString &key, int count) {
    bool isNumber = false;
    const int number = settings.value(key).toString().toInt(&isNumber);
    return isNumber && number >= 0 && number < count ? std::optional(number) : std::nullopt;
}

std::optional<double> storedTime(const QSettings &settings, const QString &key) {
    bool isNumber = false;
    const double time = settings.value(key).toString().toDouble(&isNumber);
    return isNumber && std::isfinite(time) && time > 0.0 ? std::optional(time) : std::nullopt;
}

QByteArray storedBytes(const QSettings &settings, const QString &key) {
    const auto bytes = QByteArray::fromBase64Encoding(settings.value(key).toString().toLatin1(),
                                                      QByteArray::AbortOnBase64DecodingErrors);
    return bytes ? *bytes : QByteArray();
}

void storeBytes(QSettings &settings, const QString &key, const QByteArray &bytes) {
    settings.setValue(key, QString::fromLatin1(bytes.toBase64()));
}

} // namespace inspector
