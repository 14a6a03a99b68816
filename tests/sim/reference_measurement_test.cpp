// Holds the conversation of the reference with a real ArduCopter and compares the facts with those on file, which a test of the
// simulated copter relies on.
//
// ARDUPILOT_SITL names the arducopter program, as for ardupilot_test; without it the test is skipped. The facts are those of
// ArduCopter 3.6.7, and other versions give others. REFERENCE_OUT names a file to write what was measured to.
#include "tests/sim/reference_comparison.h"
#include "tests/support/eventually.h"
#include "tests/support/program.h"
#include "tests/support/sitl.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/messages.h"
#include "core/mavlink/stream_parser.h"

#include <QtCore/QFile>
#include <QtNetwork/QTcpSocket>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::test;

namespace {

/// The vehicle's clock is its telemetry; before there is any, its heartbeats.
class SitlPeer : public ReferencePeer
{
public:
    explicit SitlPeer(quint16 port) : m_port(port)
    {
        QObject::connect(&m_socket, &QTcpSocket::readyRead, [this] { read(); });
    }

    bool connectToVehicle()
    {
        return eventually([this] {
            if (m_socket.state() == QTcpSocket::UnconnectedState)
                m_socket.connectToHost(QStringLiteral("127.0.0.1"), m_port);
            return m_socket.waitForConnected(100);
        });
    }

    void send(ByteView frame) override
    {
        m_socket.write(reinterpret_cast<const char *>(frame.data()), static_cast<qint64>(frame.size()));
    }

    bool run(double seconds) override
    {
        // On a busy machine telemetry from before the vehicle has received the request waits here, more than the time to run.
        if (!eventually([this] { return !m_socket.waitForReadyRead(0); }))
            return false;
        const double until = m_time + seconds;
        return eventually([&] { return m_time >= until; });
    }

private:
    void read()
    {
        const QByteArray bytes = m_socket.readAll();
        m_parser.feed({reinterpret_cast<const std::uint8_t *>(bytes.data()), static_cast<std::size_t>(bytes.size())},
                      [this](const mavlink::ScanItem &item) {
                          if (!item.frame)
                              return;
                          received.emplace_back(item.bytes.begin(), item.bytes.end());
                          keepTime(*item.frame);
                      });
    }

    void keepTime(const mavlink::Frame &frame)
    {
        if (frame.messageId() == mavlink::Heartbeat::kId) {
            mavlink::Heartbeat mine;
            mine.type = mavlink::MAV_TYPE_GCS;
            mine.autopilot = mavlink::MAV_AUTOPILOT_INVALID;
            std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
            send(m_writer.write(mine, buffer));
            if (m_time < m_atHeartbeat + 0.5) // no telemetry; it also stops while a mission is uploaded
                m_time += 1;
            m_atHeartbeat = m_time;
        } else if (frame.messageId() == mavlink::Attitude::kId) {
            const double boot = mavlink::Attitude::decode(frame.payload()).time_boot_ms / 1000.0;
            if (m_boot >= 0)
                m_time += boot - m_boot;
            m_boot = boot;
        }
    }

    const quint16 m_port;
    QTcpSocket m_socket;
    mavlink::StreamParser m_parser{mavlink::Dialect::builtin()};
    mavlink::FrameWriter m_writer{255, 190};
    double m_time = 0, m_boot = -1, m_atHeartbeat = 0; // s
};

} // namespace

class ReferenceMeasurementTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void realCopterStillGivesTheFacts();
};

void ReferenceMeasurementTest::realCopterStillGivesTheFacts()
{
    SKYSEAL_REQUIRES("arducopter");
    Sitl sitl;
    const quint16 port = freeTcpPort();
    const auto program = sitl.start(port, 1);
    SitlPeer peer(port);
    QVERIFY(peer.connectToVehicle());
    std::string problem;
    const ReferenceFacts facts = holdConversation(peer, problem);
    QFile out(qEnvironmentVariable("REFERENCE_OUT"));
    if (!out.fileName().isEmpty() && out.open(QIODevice::WriteOnly))
        out.write(QByteArray::fromStdString(facts.toText()));
    QCOMPARE(problem, std::string());

    QFile file(QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/data/arducopter/conversation.txt"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const ReferenceFacts known = ReferenceFacts::fromText(file.readAll().toStdString());
    std::string changes;
    for (const std::string &change : changesOf(facts, known))
        changes += change + '\n';
    QVERIFY2(changes.empty(), changes.c_str());
}

SKYSEAL_TEST(ReferenceMeasurementTest)
#include "reference_measurement_test.moc"
