// Values of the programs' JSON output.
#pragma once

#include <QtCore/QJsonObject>

namespace skyseal::test {

inline qint64 number(const QJsonValue &object, const char *key)
{
    return object[QLatin1String(key)].toInteger();
}

} // namespace skyseal::test
