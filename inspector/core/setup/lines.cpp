// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/lines.h"

namespace inspector {

namespace {

constexpr qsizetype kMostQuoted = 200; ///< characters

/// U+2028, U+2029 and the direction marks aren't control characters by category, yet break or reverse a line.
bool isShownAsIs(QChar character) {
    switch (character.category()) {
    case QChar::Other_Control:
    case QChar::Other_Format:
    case QChar::Other_NotAssigned:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
        return false;
    default:
        return true;
    }
}

QString escape(QChar character) {
    switch (character.unicode()) {
    case '\n':
        return QStringLiteral("\\n");
    case '\r':
        return QStringLiteral("\\r");
    case '\t':
        return QStringLiteral("\\t");
    default:
        const int code = character.unicode();
        return code < 0x100 ? QStringLiteral("\\x%1").arg(code, 2, 16, QLatin1Char('0'))
                            : QStringLiteral("\\u%1").arg(code, 4, 16, QLatin1Char('0'));
    }
}

/// decodePath() keeps a byte that isn't UTF-8 as the surrogate 0xdc00 + byte.
bool isEscapedByte(const QString &text, qsizetype index) {
    const bool isAlone = index == 0 || !text[index - 1].isHighSurrogate();
    return text[index].isLowSurrogate() && isAlone;
}

/// Whether the word that begins here was UTF-8. Letters in one that wasn't are there by chance, of scripts that no font
/// may have.
bool isUtf8(const QString &text, qsizetype begin) {
    for (qsizetype i = begin; i < text.size() && text[i] != QLatin1Char(' '); ++i)
        if (isEscapedByte(text, i)) return false;
    return true;
}

} // namespace

QString oneLine(const QString &text) {
    QString line;
    line.reserve(text.size());
    bool hasLetters = true;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (i == 0 || text[i - 1] == QLatin1Char(' ')) hasLetters = isUtf8(text, i);
        if (isEscapedByte(text, i))
            line += escape(QChar(text[i].unicode() & 0xff));
        else
            line +=
                isShownAsIs(text[i]) && (hasLetters || text[i].unicode() < 0x80) ? QString(text[i]) : escape(text[i]);
    }
    return line;
}

QString quoted(const QString &text) {
    const bool isLong = text.size() > kMostQuoted;
    const QString shown =
        isLong ? text.left(kMostQuoted / 2) + QStringLiteral(" ... ") + text.right(kMostQuoted / 2) : text;
    return QLatin1Char('\'') + oneLine(shown) + QLatin1Char('\'');
}

QString foundText(const QString &text) { return text.trimmed().isEmpty() ? QStringLiteral("nothing") : quoted(text); }

void report(QTextStream &messages, const QString &line) {
    messages << "physics-inspector: " << oneLine(line) << '\n';
    messages.flush();
}

} // namespace inspector
