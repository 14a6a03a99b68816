#include "tests/integration/soak_chain.h"

#include "tests/support/addresses.h"

#include <QtCore/QJsonArray>

namespace skyseal::test {

namespace {

constexpr const char *kPrefix = "soak";

/// Of the gateway, besides those of every GatewayFlight.
QByteArrayList brokerOptions(const Authority &authority, quint16 port)
{
    const QByteArray folder = authority.folder().toLocal8Bit();
    return {"mqtt = mqtts://127.0.0.1:" + QByteArray::number(port) + '/' + kPrefix, "mqtt-ca = " + folder + "ca.crt",
            "mqtt-cert = " + folder + kPrefix + ".crt", "mqtt-key = " + folder + kPrefix + ".key"};
}

const Authority &certify(Authority &authority)
{
    for (const char *name : {"broker", "dashboard", kPrefix})
        authority.certify(name);
    return authority;
}

} // namespace

const char *nameOf(Part part)
{
    switch (part) {
    case Part::Agent: return "agent";
    case Part::Gateway: return "gateway";
    case Part::Vehicle: return "vehicle";
    case Part::UdpStation: return "station on UDP";
    case Part::TcpStation: return "station on TCP";
    case Part::Broker: return "broker";
    }
    return "unknown";
}

SoakChain::SoakChain()
    : m_broker(std::make_unique<Mosquitto>(certify(m_authority))),
      m_flight({loopback("udpin", m_servedPort) + QStringLiteral(",write=command,name=counter"),
                loopback("udpout", m_stationPort) + QStringLiteral(",name=station"),
                loopback("tcpin", m_tcpPort) + QStringLiteral(",name=planner")},
               brokerOptions(m_authority, m_broker->port)),
      m_toAgent(vehiclePort(),
                [this](UdpWire::Way way, ByteView datagram) {
                    if (way == UdpWire::Way::Onward)
                        m_sent.take(datagram);
                }),
      m_toGateway(gatewayPort(), [this](UdpWire::Way way, ByteView datagram) { hear(way, datagram); })
{
    for (const Part part : {Part::Agent, Part::Vehicle, Part::UdpStation, Part::TcpStation})
        start(part);
    listen();
    mark();
}

void SoakChain::start(Part part)
{
    const Flight &flight = m_flight.flight;
    switch (part) {
    case Part::Agent:
        m_flight.air = std::make_unique<Program>(QStringLiteral("skyseal-air"), flight.airArguments(m_toGateway.port()));
        break;
    case Part::Gateway: m_flight.startGateway(); break;
    case Part::Vehicle: {
        QStringList arguments = flight.simArguments();
        arguments[arguments.indexOf(QStringLiteral("--link")) + 1] = loopback("udpout", m_toAgent.port());
        m_flight.sim = std::make_unique<Program>(QStringLiteral("skyseal-sim"), arguments);
        break;
    }
    case Part::UdpStation: m_udpStation = plainStation(m_stationPort, {}); break;
    case Part::TcpStation:
        m_tcpStation = std::make_unique<Program>(QStringLiteral("skyseal-cli"),
                                                 QStringList{QStringLiteral("monitor"), QStringLiteral("--link"),
                                                             loopback("tcp", m_tcpPort), QStringLiteral("--secure"),
                                                             QStringLiteral("off"), QStringLiteral("--no-record"),
                                                             QStringLiteral("--json")});
        break;
    case Part::Broker:
        if (m_broker->start())
            listen();
        break;
    }
}

bool SoakChain::end(Part part, bool kill)
{
    if (part == Part::Broker)
        return kill ? m_broker->kill() : m_broker->stop() == 0;
    Program &ended = *program(part);
    if (!ended.running())
        return false;
    if (kill)
        ended.kill();
    return kill || ended.terminate() == 0;
}

Program *SoakChain::program(Part part) const
{
    switch (part) {
    case Part::Agent: return m_flight.air.get();
    case Part::Gateway: return m_flight.gateway.get();
    case Part::Vehicle: return m_flight.sim.get();
    case Part::UdpStation: return m_udpStation.get();
    case Part::TcpStation: return m_tcpStation.get();
    case Part::Broker: break;
    }
    return nullptr;
}

qint64 SoakChain::pid(Part part) const
{
    return part == Part::Broker ? m_broker->pid() : program(part)->pid();
}

QByteArray SoakChain::errors(Part part)
{
    return part == Part::Broker ? QByteArray() : program(part)->errors();
}

void SoakChain::listen()
{
    m_reader = std::make_unique<MqttReader>(m_broker->port, m_authority.clientSettings("dashboard"),
                                            QByteArray(kPrefix) + "/vehicle/1/state");
    m_reader->setTaker([this](const MqttReader::Message &message) {
        m_published |= !message.retained && message.payload.contains("\"sealed\":true");
    });
}

void SoakChain::hear(UdpWire::Way way, ByteView datagram)
{
    const std::lock_guard lock(m_mutex);
    m_keyUses.take(way == UdpWire::Way::Onward,
                   QByteArray(reinterpret_cast<const char *>(datagram.data()), qsizetype(datagram.size())));
    m_heard.emplace_back(datagram.begin(), datagram.end());
    if (m_heard.size() > kHeard)
        m_heard.pop_front();
}

std::vector<Bytes> SoakChain::heard()
{
    const std::lock_guard lock(m_mutex);
    return {m_heard.begin(), m_heard.end()};
}

KeyUses SoakChain::keyUses()
{
    const std::lock_guard lock(m_mutex);
    return m_keyUses;
}

void SoakChain::mark()
{
    for (const Part part : kParts) {
        if (Program *const known = program(part))
            m_marks[part] = known->events().size();
    }
    m_published = false;
    m_client.forgetRate();
}

std::vector<QJsonObject> SoakChain::stats(Part part) const
{
    std::vector<QJsonObject> out;
    const std::vector<QJsonObject> &events = program(part)->events();
    for (std::size_t i = m_marks.at(part); i < events.size(); ++i) {
        if (events[i][QLatin1String("event")] == QLatin1String("stats"))
            out.push_back(events[i]);
    }
    return out;
}

QString SoakChain::missing()
{
    m_client.receive();
    QStringList out;
    for (const Part part : kParts) {
        if (const QString what = missingOf(part); !what.isEmpty())
            out << QLatin1String(nameOf(part)) + QLatin1Char(' ') + what;
    }
    if (m_client.rate() < 0.9 * SoakClient::kFramesASecond)
        out << QStringLiteral("client: %1 frames a second").arg(m_client.rate());
    return out.join(QStringLiteral(", "));
}

QString SoakChain::missingOf(Part part) const
{
    if (part == Part::Broker)
        return m_published ? QString() : QStringLiteral("has no news of a sealed vehicle");
    if (!program(part)->running())
        return QStringLiteral("ended: ") + QString::fromUtf8(program(part)->errors());
    if (part == Part::Vehicle)
        return {}; // the client sees its frames
    const std::vector<QJsonObject> reports = stats(part);
    if (reports.size() < 2)
        return QStringLiteral("has reported %1 times").arg(reports.size());
    const auto frames = [](const QJsonObject &report) {
        return report[QLatin1String("mavlink")][QLatin1String("frames")].toInteger();
    };
    const qint64 more = frames(reports.back()) - frames(reports[reports.size() - 2]);
    if (more < SoakClient::kFramesASecond / 2)
        return QStringLiteral("took %1 frames between two reports").arg(more);
    const bool sealing = part == Part::Agent || part == Part::Gateway;
    return sealing && !reports.back()[QLatin1String("channel")][QLatin1String("up")].toBool() ? QStringLiteral("has no session")
                                                                                              : QString();
}

} // namespace skyseal::test
