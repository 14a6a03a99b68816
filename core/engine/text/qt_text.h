// Parts of sentences: the engine's UTF-8 strings, which may contain text from outside, and numbers with their nouns.
#pragma once

#include "core/base/printable.h"
#include "core/base/reason.h"

#include <QtCore/QString>

#include <cstdint>
#include <string>
#include <string_view>

namespace skyseal::engine {

/// UTF-8 text of this program.
inline QString fromStd(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// UTF-8 that may contain text from outside: removes control characters.
inline QString qt(const std::string &text)
{
    return QString::fromStdString(printable(text));
}

/// A reason in the language of the window, or in English without a translator. Removes control characters.
QString reasonText(const Reason &reason);

/// A number with these decimals, and the decimal point of the window's language; that of English without a translator.
QString decimalText(double value, int decimals);

/// A number with its noun: `one` for 1, otherwise `many`, whose %1 is the number.
inline QString counted(std::uint64_t number, const QString &one, const QString &many)
{
    return number == 1 ? one : many.arg(number);
}

} // namespace skyseal::engine
