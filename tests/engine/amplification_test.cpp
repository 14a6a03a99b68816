// Sending from a forged address gains nothing: to each kind of message that a stranger can make, in each carrier, an
// agent that listens and a station answer with no more bytes on the wire than came in. A station may answer an announcement
// up to 2 s later (PROTOCOL.md, section 3); so what one message did not use counts for those after it, but no more than the
// longest message.
#include "tests/engine/ground.h"
#include "tests/support/stranger_messages.h"
#include "tests/support/stranger_wire.h"
#include "tests/support/test_runner.h"

#include "core/channel/cobs.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/frame_reader.h"

#include <QtNetwork/QNetworkDatagram>
#include <QtNetwork/QTcpSocket>
#include <QtNetwork/QUdpSocket>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr int kCopies = 5;
constexpr std::size_t kLongestAnswer = 145; ///< a first message in TUNNEL, byte

/// One socket to a port of this machine.
class Stranger
{
public:
    Stranger(Carrier carrier, quint16 port) : m_carrier(carrier), m_port(port)
    {
        if (isStream())
            m_tcp.connectToHost(QHostAddress::LocalHost, port);
        else
            m_udp.bind(QHostAddress::LocalHost, 0);
    }
    bool ready() const { return !isStream() || m_tcp.state() == QAbstractSocket::ConnectedState; }

    void send(const Bytes &bytes)
    {
        const auto data = reinterpret_cast<const char *>(bytes.data());
        const auto size = static_cast<qint64>(bytes.size());
        if (isStream())
            m_tcp.write(data, size);
        else
            m_udp.writeDatagram(data, size, QHostAddress::LocalHost, m_port);
    }
    /// The call of an agent that waits in the socket.
    std::optional<channel::PairingToken> call()
    {
        const QByteArray block = isStream() ? m_tcp.readAll()
            : m_udp.hasPendingDatagrams()   ? m_udp.receiveDatagram().data()
                                            : QByteArray();
        const ByteView bytes(reinterpret_cast<const std::uint8_t *>(block.constData()), static_cast<std::size_t>(block.size()));
        std::optional<channel::PairingToken> out;
        if (m_carrier == Carrier::Datagram)
            return channel::calledToken(bytes);
        if (isStream())
            m_cobs.feed(bytes, [&](MutableByteView message) { out = channel::calledToken(message); });
        else if (const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin()); frame && bytes.size() == 145)
            out = channel::calledToken(ByteView(mavlink::Tunnel::decode(frame->payload()).payload).first(127));
        return out;
    }

private:
    bool isStream() const { return m_carrier == Carrier::Serial; }

    const Carrier m_carrier;
    const quint16 m_port;
    QUdpSocket m_udp;
    QTcpSocket m_tcp;
    channel::CobsReader m_cobs;
};

/// As short as MAVLink can make it on the wire.
Bytes withoutPadding(const Bytes &bytes)
{
    const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
    mavlink::Tunnel tunnel = mavlink::Tunnel::decode(frame->payload());
    tunnel.payload.back() = 0;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView written = mavlink::FrameWriter(frame->systemId(), frame->componentId()).write(tunnel, buffer);
    return {written.begin(), written.end()};
}

/// All kinds of messages as they are on the wire, several of each.
struct MessageKind
{
    std::string name;
    std::vector<Bytes> blocks;
};
std::vector<MessageKind> kindsFor(Carrier carrier, const StrangersKnowledge &knows)
{
    std::mt19937_64 random(1);
    std::vector<MessageKind> out;
    for (const StrangerMessage &message : kStrangerMessages) {
        MessageKind kind{message.name, {}}, trimmed{std::string(message.name) + ", without padding", {}};
        for (int i = 0; i < kCopies; ++i) {
            const Bytes bytes = message.make(knows, random);
            kind.blocks.push_back(message.isBare() ? bytes : onTheWire(carrier, bytes));
            if (carrier == Carrier::Tunnel && !message.isBare())
                trimmed.blocks.push_back(withoutPadding(kind.blocks.back()));
        }
        out.push_back(std::move(kind));
        if (!trimmed.blocks.empty())
            out.push_back(std::move(trimmed));
    }
    return out;
}

/// Whether a station may answer such a message after it answered the next one. These go last: what it sends while another
/// kind comes in is then an answer to that kind.
bool answersLate(const MessageKind &kind)
{
    return kind.name.starts_with("announcement") && !kind.name.ends_with("without padding");
}

link::LinkUrl listeningUrl(Carrier carrier)
{
    return urlOf(carrier == Carrier::Serial ? "tcpin:127.0.0.1:0" : "udpin:127.0.0.1:0");
}

} // namespace

class AmplificationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listeningAgent_data();
    void listeningAgent();
    void station_data() { listeningAgent_data(); }
    void station();

private:
    /// `counters()`: those of the link. Returns the kinds that were answered.
    template<typename Counters> void attack(Stranger &stranger, const std::vector<MessageKind> &kinds, Counters &&counters)
    {
        m_answered.clear();
        std::size_t unused = 0; ///< of announcements, which a station may answer by up to two seconds later
        for (const MessageKind &kind : kinds) {
            for (const Bytes &bytes : kind.blocks) {
                const auto before = counters();
                stranger.send(bytes);
                EVENTUALLY(counters().rxBytes >= before.rxBytes + bytes.size());
                const std::uint64_t out = counters().txBytes - before.txBytes;
                const std::size_t allowed = bytes.size() + unused;
                QVERIFY2(out <= allowed,
                         qPrintable(QStringLiteral("%1: %2 for %3, of which %4 unused before")
                                        .arg(QString::fromStdString(kind.name))
                                        .arg(out)
                                        .arg(allowed)
                                        .arg(unused)));
                if (m_isStation && answersLate(kind))
                    unused = std::min<std::size_t>(allowed - out, kLongestAnswer);
                else
                    unused -= std::min<std::size_t>(unused, out > bytes.size() ? out - bytes.size() : 0);
                if (out > 0 && (m_answered.empty() || m_answered.back() != kind.name))
                    m_answered.push_back(kind.name);
            }
        }
    }
    bool isAnswered(const char *name) const { return std::ranges::find(m_answered, name) != m_answered.end(); }

    std::vector<std::string> m_answered;
    bool m_isStation = false; ///< what is attacked
};

void AmplificationTest::listeningAgent_data()
{
    QTest::addColumn<Carrier>("carrier");
    QTest::addColumn<bool>("pairing");
    const std::pair<Carrier, const char *> carriers[] = {
        {Carrier::Datagram, "datagrams"}, {Carrier::Tunnel, "TUNNEL"}, {Carrier::Serial, "serial"}};
    for (const auto &[carrier, name] : carriers) {
        QTest::addRow("%s", name) << carrier << false;
        QTest::addRow("%s, pairing", name) << carrier << true;
    }
}

void AmplificationTest::listeningAgent()
{
    m_isStation = false;
    QFETCH(Carrier, carrier);
    QFETCH(bool, pairing);
    if (pairing && carrier == Carrier::Serial)
        return; // On a connection, whose address is no forged one, it calls by itself.
    FlightRig rig;
    rig.carrier = carrier;
    rig.startAgentOn({listeningUrl(carrier)});
    VehicleOnUdp vehicle(rig.vehicleAddress());
    const auto link = [&] { return rig.agent->snapshot().grounds.at(0); };
    EVENTUALLY(rig.agent->snapshot().mavlink.frames > 50 && !link().localAddress.empty());
    Stranger stranger(carrier, portOf(link().localAddress));
    EVENTUALLY(stranger.ready());
    StrangersKnowledge knows{rig.agent->publicKey(), {}, {}, {}};
    if (pairing) {
        QVERIFY(rig.agent->openPairing("air"));
        const channel::PairingDatagram request = channel::pairingRequest();
        stranger.send(onTheWire(carrier, request));
        std::optional<channel::PairingToken> token;
        EVENTUALLY(token || (token = stranger.call()));
        knows.token = *token;
    }
    attack(stranger, kindsFor(carrier, knows), link);
    if (QTest::currentTestFailed())
        return;
    QCOMPARE(isAnswered("pairing: request"), pairing);
    QCOMPARE(isAnswered("pairing: first message to a call"), pairing);
}

void AmplificationTest::station()
{
    m_isStation = true;
    QFETCH(Carrier, carrier);
    QFETCH(bool, pairing);
    FlightRig rig;
    rig.startAgentOn({urlOf("udpin:127.0.0.1:0")}); // for its key
    Ground ground(rig.stationConfig(), listeningUrl(carrier));
    EVENTUALLY(!ground.ears->listening().empty());
    if (pairing)
        ground.station->openPairing("ground");
    const auto link = [&] { return ground.ears->snapshot->links.at(0); };
    EVENTUALLY(!ground.ears->snapshot->links.empty());
    Stranger stranger(carrier, ground.port());
    EVENTUALLY(stranger.ready());
    const StrangersKnowledge knows{rig.peersOfAgent().at(0).key, rig.agent->publicKey(), {}, {}};
    std::vector<MessageKind> kinds = kindsFor(carrier, knows);
    std::ranges::stable_sort(kinds, {}, answersLate);
    attack(stranger, kinds, link);
    if (QTest::currentTestFailed())
        return;
    QVERIFY(isAnswered("announcement of a listed agent"));
    QVERIFY(!isAnswered("announcement of a listed agent, without padding"));
    QCOMPARE(isAnswered("pairing: call"), pairing);
}

SKYSEAL_TEST(AmplificationTest)
#include "amplification_test.moc"
