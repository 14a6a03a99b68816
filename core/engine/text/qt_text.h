// Parts of sentences: the engine's UTF-8 strings, which may contain text of others, and numbers with their nouns.
#pragma once

#include "core/base/printable.h"

#include <QtCore/QString>

#include <cstdint>
#include <string>

namespace skyseal::engine {

inline QString qt(const std::string &text)
{
    return QString::fromStdString(printable(text));
}

/// A number with its noun: `one` for 1, otherwise `many`, whose %1 is the number.
inline QString counted(std::uint64_t number, const QString &one, const QString &many)
{
    return number == 1 ? one : many.arg(number);
}

} // namespace skyseal::engine
