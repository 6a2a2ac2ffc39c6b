// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/levels.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QCoreApplication>
#include <QDir>

#include <algorithm>

namespace inspector {

namespace {

const QString kSuffix = QStringLiteral(".txt");

/// The marker in the first line of a maze file; comments may precede it.
bool isMaze(const QString &path) {
    constexpr qint64 kBeginning = 4096; // bytes
    return beginningOf(path, kBeginning).contains("physics-maze");
}

/// Natural order: digits compare as numbers, 2 before 10.
bool isNameBefore(const QString &a, const QString &b) {
    qsizetype i = 0;
    qsizetype j = 0;
    const auto isDigit = [](QChar character) { return character >= QLatin1Char('0') && character <= QLatin1Char('9'); };
    const auto number = [&](const QString &name, qsizetype &place) {
        const qsizetype begin = place;
        while (place < name.size() && isDigit(name[place])) ++place;
        QString digits = name.mid(begin, place - begin);
        while (digits.size() > 1 && digits[0] == QLatin1Char('0')) digits.remove(0, 1);
        return digits;
    };
    while (i < a.size() && j < b.size()) {
        if (isDigit(a[i]) && isDigit(b[j])) {
            const QString first = number(a, i);
            const QString second = number(b, j);
            if (first.size() != second.size()) return first.size() < second.size();
            if (first != second) return first < second;
        } else if (a[i] != b[j]) {
            return a[i] < b[j];
        } else {
            ++i, ++j;
        }
    }
    return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

} // namespace

Level levelOfFile(const QString &path) {
    const qsizetype slash = path.lastIndexOf(QLatin1Char('/'));
    const qsizetype point = path.lastIndexOf(QLatin1Char('.'));
    const QString stem = point > slash + 1 ? path.left(point) : path;
    const QString mesh = stem + QStringLiteral(".obj");
    return {stem.mid(slash + 1), path, fileExists(mesh) ? mesh : QString()};
}

std::vector<Level> levelsIn(const QString &folder) {
    std::vector<Level> levels;
    if (folder.isEmpty()) return levels;
    QStringList names = fileNamesIn(folder);
    std::sort(names.begin(), names.end(), isNameBefore);
    for (const QString &name : names) {
        const QString path = folder + QLatin1Char('/') + name;
        if (name.endsWith(kSuffix) && isMaze(path)) levels.push_back(levelOfFile(path));
    }
    return levels;
}

QString levelsFolder() {
    const QByteArray own = qgetenv("PHYSICS_LEVELS");
    if (!own.isEmpty()) return decodePath(own);
    const QString installed = QCoreApplication::applicationDirPath() + QStringLiteral("/../share/physics/levels");
    const QString ofSource = QStringLiteral(INSPECTOR_SOURCE_LEVELS);
    return QDir::cleanPath(!isFolder(installed) && isFolder(ofSource) ? ofSource : installed);
}

std::optional<int> numberOf(const Level &level) {
    bool isNumber = false;
    const int number = level.name.toInt(&isNumber);
    return isNumber && number > 0 ? std::optional(number) : std::nullopt;
}

Level firstLevel(const std::vector<Level> &levels) {
    const auto found =
        std::find_if(levels.begin(), levels.end(), [](const Level &level) { return numberOf(level) == 1; });
    return found != levels.end() ? *found : levels.front();
}

std::optional<Level> findLevel(const std::vector<Level> &levels, const QString &text, QString *error) {
    bool isNumber = false;
    const int number = text.toInt(&isNumber);
    if (!isNumber) return levelOfFile(text);
    const auto refuse = [&](const QString &expected) {
        if (error) *error = QStringLiteral("expected %1, found %2").arg(expected).arg(number);
        return std::nullopt;
    };
    std::vector<int> numbers; // ascending, as the names are
    for (const Level &level : levels) {
        if (numberOf(level) == number) return level;
        if (const std::optional<int> other = numberOf(level)) numbers.push_back(*other);
    }
    if (numbers.empty() && number >= 1 && size_t(number) <= levels.size()) return levels[size_t(number) - 1];
    if (levels.empty()) {
        if (error)
            *error = QStringLiteral("no levels found in the folder %1 (PHYSICS_LEVELS names another)")
                         .arg(quoted(levelsFolder()));
        return std::nullopt;
    }
    if (numbers.empty()) return refuse(QStringLiteral("1 to %1").arg(levels.size()));
    const bool isComplete = numbers.back() - numbers.front() + 1 == int(numbers.size());
    const QString expected = isComplete ? QStringLiteral("%1 to %2") : QStringLiteral("a level of %1 to %2");
    return refuse(expected.arg(numbers.front()).arg(numbers.back()));
}

} // namespace inspector
