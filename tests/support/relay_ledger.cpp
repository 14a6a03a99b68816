#include "tests/support/relay_ledger.h"

#include <QtCore/QJsonArray>

#include <map>
#include <set>
#include <utility>

namespace skyseal::test {

namespace {

/// The numbers of one counter, which begins at 0, in the order of arrival.
struct Stream
{
    qint64 newest = -1;
    std::set<qint64> arrived;

    enum class Arrival { Newest, Late, Again };
    Arrival take(qint64 number)
    {
        if (!arrived.insert(number).second)
            return Arrival::Again;
        return number > std::exchange(newest, std::max(newest, number)) ? Arrival::Newest : Arrival::Late;
    }
};

struct Place
{
    int stream = 0;
    qint64 number = 0;
};

/// The epochs of one session: each counts from 0.
struct Session
{
    int bits = -1; ///< of the epoch that is sent under
    int epochs = 0;
    int newest = 0; ///< epoch of which something arrived
    std::map<int, Stream> streams;
    std::map<int, qint64> sent; ///< under each epoch

    /// The sender reports the final count of a past epoch; in the current one, losses are known up to the newest record.
    qint64 lost() const
    {
        qint64 out = 0;
        for (const auto &[epoch, stream] : streams) {
            const auto known = epoch < newest ? std::max(sent.at(epoch), stream.newest + 1) : stream.newest + 1;
            out += known - static_cast<qint64>(stream.arrived.size());
        }
        return out;
    }
};

struct Datagram
{
    int session = 0;
    std::vector<Place> sealed; ///< streams are epochs
    std::vector<Place> frames; ///< streams are senders
    bool inPlace = false;
};

/// Extends MAVLink's 8-bit sequence numbers by the order in which the frames of a sender passed.
struct Sender
{
    int last = -1;
    qint64 sent = 0;
    qint64 first = -1; ///< frame that arrived; losses before it cannot be known
    Stream stream;
};

class Replay
{
public:
    explicit Replay(std::vector<RelayLedger::Sealed> &sealed, std::vector<RelayLedger::Frames> &frames)
        : m_sealed(sealed), m_frames(frames)
    {}

    Datagram takeIn(const QJsonObject &event)
    {
        Datagram out;
        // Frames sealed in place do not name their session.
        out.session = m_session = event[QLatin1String("connection")].toInt(m_session);
        Session &session = m_sessions[m_session];
        for (const QJsonValue counter : event[QLatin1String("counters")].toArray()) {
            if (const int bits = event[QLatin1String("epoch")].toInt(); bits != std::exchange(session.bits, bits))
                ++session.epochs;
            qint64 &sent = session.sent[session.epochs];
            sent = std::max(sent, counter.toInteger() + 1);
            out.sealed.push_back({session.epochs, counter.toInteger()});
        }
        for (const QJsonValue frame : event[QLatin1String("frames")].toArray()) {
            const QJsonArray parts = frame.toArray();
            const int key = parts[0].toInt() * 256 + parts[1].toInt();
            Sender &sender = m_senders[key];
            const int sequence = parts[2].toInt();
            sender.sent += sender.last < 0 ? 0 : (sequence - sender.last) & 0xff;
            sender.last = sequence;
            out.frames.push_back({key, sender.sent});
        }
        out.inPlace = !out.sealed.empty();
        return out;
    }

    void takeOut(const Datagram &datagram)
    {
        bool copy = false;
        for (const Place &place : datagram.sealed)
            copy = takeSealed(m_sessions[datagram.session], place);
        for (const Place &place : datagram.frames) {
            if (!datagram.inPlace || !copy)
                takeFrame(place);
        }
    }

private:
    bool takeSealed(Session &session, const Place &place)
    {
        const qint64 lostBefore = session.lost();
        session.newest = std::max(session.newest, place.stream);
        const Stream::Arrival arrival = session.streams[place.stream].take(place.number);
        RelayLedger::Sealed now = m_sealed.back();
        now.good += arrival != Stream::Arrival::Again;
        now.late += arrival == Stream::Arrival::Late;
        now.replayed += arrival == Stream::Arrival::Again;
        now.lost += session.lost() - lostBefore;
        m_sealed.push_back(now);
        return arrival == Stream::Arrival::Again;
    }

    void takeFrame(const Place &place)
    {
        Sender &sender = m_senders[place.stream];
        const qint64 before = sender.stream.newest;
        const bool first = sender.first < 0;
        if (first)
            sender.first = place.number;
        const Stream::Arrival arrival = sender.stream.take(place.number);
        RelayLedger::Frames now = m_frames.back();
        ++now.received;
        now.duplicate += arrival == Stream::Arrival::Again;
        now.late += arrival == Stream::Arrival::Late;
        if (arrival == Stream::Arrival::Newest && !first)
            now.lost += place.number - before - 1;
        else if (arrival == Stream::Arrival::Late && place.number > sender.first)
            --now.lost;
        m_frames.push_back(now);
    }

    std::vector<RelayLedger::Sealed> &m_sealed;
    std::vector<RelayLedger::Frames> &m_frames;
    std::map<int, Session> m_sessions;
    std::map<int, Sender> m_senders;
    int m_session = 0;
};

} // namespace

RelayLedger::RelayLedger(const std::vector<QJsonObject> &events, const QString &direction)
{
    Replay replay(m_sealed, m_frames);
    std::map<qint64, Datagram> datagrams;
    qint64 newest = -1;
    for (const QJsonObject &event : events) {
        if (event[QLatin1String("direction")].toString() != direction)
            continue;
        const qint64 number = event[QLatin1String("sequence")].toInteger();
        if (event[QLatin1String("event")] == QLatin1String("in")) {
            const Datagram &datagram = datagrams[number] = replay.takeIn(event);
            const auto units = static_cast<qint64>(datagram.inPlace ? datagram.sealed.size() : datagram.frames.size());
            m_dropped += event[QLatin1String("fate")] == QLatin1String("passed") ? 0 : units;
            m_duplicated += event[QLatin1String("duplicated")].toBool() ? units : 0;
        } else if (event[QLatin1String("event")] == QLatin1String("out")) {
            m_overtaken += number < newest;
            newest = std::max(newest, number);
            replay.takeOut(datagrams[number]);
        }
    }
}

QString words(const RelayLedger::Sealed &sealed)
{
    return QStringLiteral("%1 good, %2 lost, %3 late, %4 replayed")
        .arg(sealed.good)
        .arg(sealed.lost)
        .arg(sealed.late)
        .arg(sealed.replayed);
}

QString words(const RelayLedger::Frames &frames)
{
    return QStringLiteral("%1 frames, %2 lost, %3 late, %4 duplicate")
        .arg(frames.received)
        .arg(frames.lost)
        .arg(frames.late)
        .arg(frames.duplicate);
}

} // namespace skyseal::test
