// The books of one direction of a link, kept from the log of `skyseal-cli impair --json --datagrams` alone: what a receiver
// that counts rightly has counted after each datagram that reached it. The log knows every datagram's fate and the order in
// which copies left; who sealed, opened and counted has no part in it.
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

    /// After so many sealed units had arrived, copies included; the last entry is the end. Entry 0 is the beginning.
    const std::vector<Sealed> &sealed() const { return m_sealed; }
    /// After so many frames had reached the receiver's MAVLink side: copies of frames sealed in place do not, those of clear
    /// frames do.
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
