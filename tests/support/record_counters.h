// Counters of received records in the JSON reports of the programs.
#pragma once

#include <QtCore/QJsonObject>

namespace skyseal::test {

/// The counters of received records in `channel` of a report: its `rx` without the datagrams that belong to no session, which
/// are mostly repeated handshake messages (a busy machine or a slow link makes the station repeat its first message).
inline QJsonObject receivedRecords(const QJsonValue &channel)
{
    QJsonObject out = channel[QLatin1String("rx")].toObject();
    const QJsonValue unmatched = channel[QLatin1String("unmatched")];
    for (const char *name : {"replayed", "forged", "malformed"}) {
        const QLatin1String key(name);
        out[key] = out[key].toInteger() - unmatched[key].toInteger();
    }
    return out;
}

} // namespace skyseal::test
