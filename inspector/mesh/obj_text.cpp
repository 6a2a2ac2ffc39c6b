// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/obj_text.h"

#include "core/setup/lines.h"

#include <QHash>
#include <QList>

#include <charconv>
#include <cmath>

namespace inspector::gl {

namespace {

/// An invalid line: what was expected, what was found.
struct WrongLine {
    QString reason;
};

QString shown(const QByteArray &text) { return foundText(QString::fromUtf8(text)); }

[[noreturn]] void fail(const QString &expected, const QByteArray &found) {
    throw WrongLine{QStringLiteral("expected %1, found %2").arg(expected, shown(found))};
}

struct Line {
    int number; ///< of its first line in the file, from 1
    QByteArray keyword;
    QByteArray rest; ///< words separated by single spaces
};

/// Comments begin at a # that isn't inside a word; names may contain one.
QByteArray withoutComment(const QByteArray &line) {
    for (qsizetype i = 0; i < line.size(); ++i)
        if (line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) return line.left(i);
    return line;
}

/// Visits all non-empty lines; a backslash at the end of a line continues it.
void forEachLine(QByteArray text, const std::function<void(const Line &)> &visit) {
    if (text.startsWith("\xef\xbb\xbf")) text.remove(0, 3);
    text.replace("\r\n", "\n").replace('\r', '\n').replace('\0', ' ');
    int number = 0;
    int begin = 1;
    QByteArray joined;
    for (qsizetype place = 0; place <= text.size();) {
        qsizetype end = text.indexOf('\n', place);
        if (end < 0) end = text.size();
        QByteArray line = withoutComment(text.mid(place, end - place));
        place = end + 1;
        if (joined.isEmpty()) begin = number + 1;
        ++number;
        const QByteArray trimmed = line.trimmed();
        const bool goesOn = trimmed.endsWith('\\') && place <= text.size();
        joined += (goesOn ? trimmed.chopped(1) : trimmed) + ' ';
        if (goesOn) continue;
        const QByteArray words = joined.simplified();
        joined.clear();
        if (words.isEmpty()) continue;
        const qsizetype space = words.indexOf(' ');
        visit({begin, space < 0 ? words : words.left(space), space < 0 ? QByteArray() : words.mid(space + 1)});
    }
}

template<typename Number>
std::optional<Number> numberFrom(QByteArray word) {
    if (word.startsWith('+')) word.remove(0, 1);
    Number number{};
    const char *end = word.constData() + word.size();
    const auto result = std::from_chars(word.constData(), end, number);
    return result.ec == std::errc() && result.ptr == end ? std::optional(number) : std::nullopt;
}

/// The first `count` words as validated numbers.
QByteArray numbersOf(const Line &line, qsizetype count, double limit) {
    const QList<QByteArray> words = line.rest.split(' ');
    QByteArray text;
    for (qsizetype i = 0; i < count; ++i) {
        const std::optional<double> number = i < words.size() ? numberFrom<double>(words[i]) : std::nullopt;
        if (!number || !std::isfinite(*number))
            fail(QStringLiteral("%1 finite numbers").arg(count), line.keyword + ' ' + line.rest);
        if (!(std::abs(*number) <= limit)) fail(QStringLiteral("numbers up to %1").arg(limit), words[i]);
        text += ' ' + QByteArray::number(*number, 'g', 9);
    }
    return text;
}

class ObjCheck {
public:
    explicit ObjCheck(const MaterialSource &materials)
        : m_source(materials) {}

    void readObj(const Line &line) {
        m_line = line.number;
        if (line.keyword == "v") return readPosition(line);
        if (line.keyword == "vn") return readNormal(line);
        if (line.keyword == "f") return readFace(line);
        if (line.keyword == "o" || line.keyword == "g")
            m_checked.shapes += "o " + QByteArray::number(++m_objects) + '\n';
        if (line.keyword == "mtllib") return readLibraries(line.rest);
        if (line.keyword == "usemtl") return useMaterial(line.rest);
    }

    int line() const { return m_line; }
    int faces() const { return m_faces; }
    CheckedObj take() { return std::move(m_checked); }

private:
    void readPosition(const Line &line) {
        ++m_positions;
        m_checked.shapes += 'v' + numbersOf(line, 3, kLargestCoordinate) + '\n';
    }

    void readNormal(const Line &line) {
        ++m_normals;
        m_checked.shapes += "vn" + numbersOf(line, 3, 1e30) + '\n';
    }

    /// Position and normal of each corner, counted from 1; texture coordinates are ignored.
    void readFace(const Line &line) {
        const QList<QByteArray> corners = line.rest.isEmpty() ? QList<QByteArray>() : line.rest.split(' ');
        if (corners.size() < 3)
            throw WrongLine{QStringLiteral("expected a face of three or more corners, found %1").arg(corners.size())};
        m_checked.shapes += 'f';
        for (const QByteArray &corner : corners) {
            const QList<QByteArray> indices = corner.split('/'); // position / texture / normal
            const int position = indexOf(indices[0], m_positions);
            const bool hasNormal = indices.size() > 2 && !indices[2].isEmpty();
            const int normal = hasNormal ? indexOf(indices[2], m_normals) : 0;
            if (position == 0 || (hasNormal && normal == 0) || indices.size() > 3)
                throw WrongLine{QStringLiteral("expected indices of the %1 vertices and %2 normals above, found %3")
                                    .arg(m_positions)
                                    .arg(m_normals)
                                    .arg(shown(corner))};
            m_checked.shapes += ' ' + QByteArray::number(position);
            if (hasNormal) m_checked.shapes += "//" + QByteArray::number(normal);
        }
        m_checked.shapes += '\n';
        ++m_faces;
    }

    /// The 1-based index; negative input counts backwards from the end. 0 if absent.
    static int indexOf(const QByteArray &word, int count) {
        const int index = numberFrom<int>(word).value_or(0);
        if (index < -count || index > count) return 0;
        return index < 0 ? count + 1 + index : index;
    }

    /// A single name with spaces, if such a file exists, otherwise several names.
    void readLibraries(const QByteArray &rest) {
        const QString all = QString::fromUtf8(rest).replace(QLatin1Char('\\'), QLatin1Char('/'));
        QString reason;
        if (const auto text = m_source(all, &reason)) return readLibrary(*text);
        const QStringList names = all.split(QLatin1Char(' '), Qt::SkipEmptyParts);
        for (const QString &name : names) {
            const auto text = names.size() > 1 ? m_source(name, &reason) : std::nullopt;
            if (text)
                readLibrary(*text);
            else
                note(QStringLiteral("material file ") + reason);
        }
    }

    void readLibrary(const QByteArray &text) {
        forEachLine(text, [this](const Line &line) {
            const bool isColour = line.keyword == "Kd" || line.keyword == "Ks" || line.keyword == "Ke";
            if (line.keyword == "newmtl") return addMaterial(line.rest);
            if (m_count == 0 || !(isColour || line.keyword == "Ns")) return;
            try {
                m_checked.materials += line.keyword + numbersOf(line, isColour ? 3 : 1, 1e6) + '\n';
            } catch (const WrongLine &wrong) {
                note(QStringLiteral("material file, line %1: ").arg(line.number) + wrong.reason);
            }
        });
    }

    void addMaterial(const QByteArray &name) {
        m_materials.insert(name, m_count);
        m_checked.materials += "newmtl m" + QByteArray::number(m_count++) + '\n';
    }

    void useMaterial(const QByteArray &name) {
        const auto found = m_materials.constFind(name);
        if (found == m_materials.cend())
            note(QStringLiteral("expected a material of the .mtl file, found ") + shown(name));
        const QByteArray number = found == m_materials.cend() ? "none" : QByteArray::number(*found);
        m_checked.shapes += "usemtl m" + number + '\n';
    }

    void note(const QString &line) {
        if (m_checked.note.isEmpty()) m_checked.note = QStringLiteral("%1: %2").arg(m_line).arg(line);
    }

    const MaterialSource &m_source;
    CheckedObj m_checked;
    int m_line = 0;
    int m_positions = 0;
    int m_normals = 0;
    int m_faces = 0;
    int m_objects = 0;
    int m_count = 0;                    ///< materials
    QHash<QByteArray, int> m_materials; ///< the last definition of a name wins
};

} // namespace

std::optional<CheckedObj> checkObj(const QByteArray &text, const MaterialSource &materials, QString *error) {
    ObjCheck check(materials);
    try {
        forEachLine(text, [&](const Line &line) { check.readObj(line); });
    } catch (const WrongLine &wrong) {
        *error = QStringLiteral("%1: %2").arg(check.line()).arg(wrong.reason);
        return std::nullopt;
    }
    if (check.faces() > 0) return check.take();
    *error = QStringLiteral(" expected at least one face, found none");
    return std::nullopt;
}

} // namespace inspector::gl
