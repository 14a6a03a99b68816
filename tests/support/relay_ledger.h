// Expected counters of a receiver after each datagram of one direction of a link, computed from the log of
// `skyseal-cli impair --json --datagrams` alone. The log has the fate of every datagram and the order in which copies left; the
// code under test, which seals, opens and counts, is not involved.
#pragma once

#include <QtCore/QJsonObject>
#include <QtCore/QString>

#include <cstdint>
#include <vector>

namespace skyseal::test {

class RelayLedger
{
public:
    /// Sealed units: records, and frames sealed in place.
    struct Sealed
    {
        qint64 good = 0, lost = 0, late = 0, replayed = 0;
        bool operator==(const Sealed &) const = default;
    };
    /// MAVLink frames whose headers are in the clear, by their sequence numbers.
    struct Frames
    {
        qint64 received = 0, lost = 0, late = 0, duplicate = 0;
        bool operator==(const Frames &) const = default;
    };

    /// `direction`: "forward" or "backward".
    RelayLedger(const std::vector<QJsonObject> &events, const QString &direction);

    /// Counters by the number of sealed units that have arrived, copies included: entry 0 is the start, the last is the end.
    const std::vector<Sealed> &sealed() const { return m_sealed; }
    /// Counters by the number of frames that have reached the receiver's MAVLink layer. Copies of clear frames reach it,
    /// copies of frames sealed in place do not.
    const std::vector<Frames> &frames() const { return m_frames; }

    qint64 dropped() const { return m_dropped; }       ///< sealed units and clear frames in datagrams that were dropped
    qint64 duplicated() const { return m_duplicated; } ///< the same of those that went out twice
    qint64 overtaken() const { return m_overtaken; }   ///< datagrams that left after a later one

private:
    std::vector<Sealed> m_sealed{{}};
    std::vector<Frames> m_frames{{}};
    qint64 m_dropped = 0, m_duplicated = 0, m_overtaken = 0;
};

QString words(const RelayLedger::Sealed &sealed);
QString words(const RelayLedger::Frames &frames);

} // namespace skyseal::test
