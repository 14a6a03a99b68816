// Conversion of the engine's UTF-8 strings for sentences.
#pragma once

#include <QtCore/QString>

#include <string>

namespace skyseal::engine {

inline QString qt(const std::string &text)
{
    return QString::fromStdString(text);
}

} // namespace skyseal::engine
