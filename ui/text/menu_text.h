// The texts of menu entries in lists, and finding them by words.
#pragma once

#include <QtCore/QString>
#include <QtCore/QStringList>

#include <algorithm>

namespace skyseal::ui {

/// The text of a menu entry without the mark of its mnemonic.
inline QString withoutMnemonic(QString text)
{
    return text.remove(QLatin1Char('&'));
}

/// True if `text` contains every word of `typed`, in either case. Nothing typed is contained in every text.
inline bool containsWords(const QString &text, const QString &typed)
{
    const QStringList words = typed.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::ranges::all_of(words, [&](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace skyseal::ui
