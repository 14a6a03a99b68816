// Values of the programs' JSON output.
#pragma once

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QJsonValue>

#include <string>

namespace skyseal::test {

/// Empty if `text` is no object of JSON.
inline QJsonObject parsed(const std::string &text)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}

inline qint64 number(const QJsonValue &object, const char *key)
{
    return object[QLatin1String(key)].toInteger();
}

/// For an event "session" or an entry of "sessions".
inline bool isUp(const QJsonObject &session)
{
    return session[QLatin1String("state")] == QLatin1String("up");
}

} // namespace skyseal::test
