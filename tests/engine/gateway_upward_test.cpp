// The frames of a client of the gateway that may write reach the vehicle byte for byte, through gateway and agent: the version
// of MAVLink, sequence numbers, ids and signatures are the client's, and unsigned frames stay unsigned.
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/frame_intake.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/engine/served_flight.h"
#include "tests/support/bare_socket.h"
#include "tests/support/clear_frames.h"
#include "tests/support/heartbeat.h"
#include "tests/support/test_runner.h"

#include <QtNetwork/QTcpSocket>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// The system of the client's frames, by which they are told from the gateway's own requests.
constexpr std::uint8_t kClientSystem = 250;

/// A frame with this sequence number; signed ones have an arbitrary signature.
template<typename Message> Bytes clientFrame(int version, std::uint8_t sequence, const Message &message, bool isSigned = false)
{
    std::array<std::uint8_t, Message::kMaxLength> payload;
    message.encode(payload);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const MutableByteView frame = mavlink::writeFrame(buffer, version, sequence, kClientSystem, 190, Message::kId,
                                                      Message::kCrcExtra, Message::kMinLength, payload,
                                                      isSigned ? mavlink::kFlagSigned : std::uint8_t(0));
    if (isSigned) {
        for (std::size_t i = 0; i < mavlink::kSignatureLength; ++i)
            frame.last(mavlink::kSignatureLength)[i] = static_cast<std::uint8_t>(0xa0 + i);
    }
    return Bytes(frame.begin(), frame.end());
}

/// Frames that would change if the gateway or the agent decoded them and wrote them anew.
std::vector<Bytes> unusualFrames()
{
    const mavlink::CommandLong speed{
        .target_system = 1, .target_component = 1, .command = mavlink::MAV_CMD_DO_CHANGE_SPEED, .param2 = 7};
    const mavlink::ParamSet parameter{.target_system = 1, .target_component = 1, .param_value = 1.5f};
    std::vector<Bytes> out{
        clientFrame(1, 9, mavlink::Heartbeat{.type = mavlink::MAV_TYPE_GCS}),
        clientFrame(1, 255, parameter),
        clientFrame(2, 200, speed),
        clientFrame(2, 200, speed), // the same number again
        clientFrame(2, 3, speed),   // and an earlier one
        clientFrame(2, 4, parameter, true),
        clientFrame(2, 4, mavlink::MissionCount{.target_system = 1, .target_component = 1, .count = 2}),
        clientFrame(1, 5, mavlink::RcChannelsOverride{.target_system = 1, .target_component = 1, .chan3_raw = 1500}),
    };
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const auto add = [&out](ByteView frame) { out.emplace_back(frame.begin(), frame.end()); };
    const std::array<std::uint8_t, 9> payload{1, 2, 3, 4, 5, 6, 7, 8, 9};
    add(mavlink::writeFrame(buffer, 2, 77, kClientSystem, 7, 0x00A1B2C3, 0x5a, 9, payload)); // of another dialect
    // With a field behind those that are known here.
    std::array<std::uint8_t, mavlink::MissionCount::kMaxLength + 3> longer{};
    longer.back() = 1;
    longer[2] = 1; // its target
    add(mavlink::writeFrame(buffer, 2, 78, kClientSystem, 190, mavlink::MissionCount::kId, mavlink::MissionCount::kCrcExtra,
                            mavlink::MissionCount::kMinLength, longer));
    return out;
}

QByteArray hexOf(const Bytes &frame)
{
    return QByteArray(reinterpret_cast<const char *>(frame.data()), static_cast<qsizetype>(frame.size())).toHex(' ');
}

/// The autopilot's end of the agent's line.
struct BareVehicle
{
    explicit BareVehicle(FlightRig &rig) : agentPort(portOf(rig.vehicleAddress())) {}

    void sendHeartbeat() { socket.send(agentPort, std::array{viewOf(heartbeat)}); }
    /// All frames of the client that arrived, without copies of `leftOut`.
    const std::vector<Bytes> &framesBut(const Bytes &leftOut)
    {
        while (const std::size_t count = socket.receive()) {
            for (std::size_t i = 0; i < count; ++i) {
                mavlink::scanFrames(socket.received(i), mavlink::Dialect::builtin(), [this](const mavlink::ScanItem &item) {
                    if (mavlink::isWholeFrame(item) && mavlink::systemIdOf(item.bytes) == kClientSystem)
                        frames.emplace_back(item.bytes.begin(), item.bytes.end());
                });
            }
        }
        heard = heard || !frames.empty();
        std::erase(frames, leftOut);
        return frames;
    }

    BareSocket socket;
    const std::uint16_t agentPort;
    const QByteArray heartbeat = clearHeartbeat(1, 1, false);
    std::vector<Bytes> frames;
    bool heard = false; ///< any frame of the client
};

} // namespace

class GatewayUpwardTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void framesArriveAsTheClientSentThem_data();
    void framesArriveAsTheClientSentThem();
};

void GatewayUpwardTest::framesArriveAsTheClientSentThem_data()
{
    QTest::addColumn<QString>("url");
    QTest::newRow("UDP") << QStringLiteral("udpin:127.0.0.1:0");
    QTest::newRow("TCP") << QStringLiteral("tcpin:127.0.0.1:0");
}

void GatewayUpwardTest::framesArriveAsTheClientSentThem()
{
    QFETCH(QString, url);
    ServedFlight flight(",write=all", channel::PeerRole::Pilot, url.toStdString());
    BareVehicle vehicle(flight.rig);
    BareSocket datagrams;
    QTcpSocket stream;
    const bool isStream = url.startsWith(QLatin1String("tcp"));
    if (isStream)
        stream.connectToHost(QHostAddress::LocalHost, flight.port());
    const auto send = [&](const Bytes &frame) {
        if (isStream)
            stream.write(reinterpret_cast<const char *>(frame.data()), static_cast<qint64>(frame.size()));
        else
            datagrams.send(flight.port(), std::array{ByteView(frame)});
    };

    const Bytes first = clientFrame(2, 1, mavlink::Timesync{.ts1 = 5, .target_system = 1});
    const auto isThrough = [&] { // the way to the vehicle is known from its heartbeat on
        vehicle.sendHeartbeat();
        send(first);
        vehicle.framesBut(first);
        return vehicle.heard;
    };
    EVENTUALLY(isThrough());
    const std::vector<Bytes> sent = unusualFrames();
    for (const Bytes &frame : sent)
        send(frame);
    EVENTUALLY(vehicle.framesBut(first).size() >= sent.size());
    for (std::size_t i = 0; i < sent.size(); ++i)
        QCOMPARE(hexOf(vehicle.frames[i]), hexOf(sent[i]));
    QCOMPARE(vehicle.frames.size(), sent.size());
    QCOMPARE(flight.client().counters.denied, std::uint64_t(0));
}

SKYSEAL_TEST(GatewayUpwardTest)
#include "gateway_upward_test.moc"
