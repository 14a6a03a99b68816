// Conversion of the engine's UTF-8 strings for sentences. They may contain text of others.
#pragma once

#include "core/base/printable.h"

#include <QtCore/QString>

#include <string>

namespace skyseal::engine {

inline QString qt(const std::string &text)
{
    return QString::fromStdString(printable(text));
}

} // namespace skyseal::engine
