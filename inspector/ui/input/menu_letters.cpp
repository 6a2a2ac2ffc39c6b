// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/input/menu_letters.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QHash>
#include <QKeySequence>
#include <QMenu>
#include <QSet>

#include <vector>

namespace inspector::ui {

namespace {

const QLatin1Char kMark('&');

/// The letters of a menu's entries: a matching, as an entry that comes late may need one that others could do without.
class Letters {
public:
    void add(QAction &entry) {
        const QKeySequence own = QKeySequence::mnemonic(entry.text());
        const QChar letter = own.isEmpty() ? QChar() : QChar(own[0].key());
        if (!own.isEmpty() && !m_kept.contains(letter)) {
            m_kept += letter;
            return;
        }
        m_entries.push_back({&entry, plainText(entry.text()), -1});
    }

    void give() {
        for (size_t entry = 0; entry < m_entries.size(); ++entry) {
            QSet<QChar> tried = m_kept;
            give(entry, tried);
        }
        for (const Entry &entry : m_entries) {
            QString text = entry.text;
            if (entry.place >= 0)
                text.insert(entry.place, QChar(1)); // not yet the mark, which is doubled where it is text
            entry.action->setText(text.replace(kMark, QLatin1String("&&")).replace(QChar(1), kMark));
        }
    }

private:
    struct Entry {
        QAction *action;
        QString text;    ///< plain
        qsizetype place; ///< of the letter; -1: none is left
    };

    /// In the order in which they are taken: first those that begin a word.
    static std::vector<qsizetype> placesIn(const QString &text) {
        std::vector<qsizetype> places;
        for (const bool begins : {true, false})
            for (qsizetype i = 0; i < text.size(); ++i)
                if (text[i].isLetterOrNumber() && begins == (i == 0 || !text[i - 1].isLetterOrNumber()))
                    places.push_back(i);
        return places;
    }

    bool take(size_t entry, qsizetype place) {
        m_owners[m_entries[entry].text[place].toUpper()] = entry;
        m_entries[entry].place = place;
        return true;
    }

    /// Whether the entry has got a letter that wasn't tried: a free one, or one whose owner can have another.
    bool give(size_t entry, QSet<QChar> &tried) {
        const QString text = m_entries[entry].text;
        const std::vector<qsizetype> places = placesIn(text);
        for (const qsizetype place : places) {
            const QChar letter = text[place].toUpper();
            if (!tried.contains(letter) && !m_owners.contains(letter)) return take(entry, place);
        }
        for (const qsizetype place : places) {
            const QChar letter = text[place].toUpper();
            if (tried.contains(letter)) continue;
            tried += letter;
            if (give(m_owners[letter], tried)) return take(entry, place);
        }
        return false;
    }

    std::vector<Entry> m_entries;
    QSet<QChar> m_kept;
    QHash<QChar, size_t> m_owners;
};

} // namespace

MenuLetters::MenuLetters(QWidget &window)
    : QObject(&window) {
    qApp->installEventFilter(this);
}

bool MenuLetters::eventFilter(QObject *object, QEvent *event) {
    const auto *menu = event->type() == QEvent::Show ? qobject_cast<QMenu *>(object) : nullptr;
    if (!menu) return false;
    Letters letters;
    for (QAction *entry : menu->actions())
        if (!entry->isSeparator()) letters.add(*entry);
    letters.give();
    return false;
}

QString plainText(QString text) {
    for (qsizetype mark = text.indexOf(kMark); mark >= 0; mark = text.indexOf(kMark, mark + 1)) text.remove(mark, 1);
    return text;
}

} // namespace inspector::ui
