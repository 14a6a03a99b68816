// A whole chain of programs that are killed and started again: a simulated vehicle that sends a thousand frames a second,
// its agent, a gateway, and behind it two ground stations, a program that counts and a broker. A wire is between vehicle and
// agent, and one between agent and gateway.
#pragma once

#include "tests/integration/soak_client.h"
#include "tests/support/frame_trail.h"
#include "tests/support/gateway_flight.h"
#include "tests/support/key_uses.h"
#include "tests/support/mosquitto.h"
#include "tests/support/mqtt_reader.h"
#include "tests/support/udp_wire.h"

#include <array>
#include <deque>

namespace skyseal::test {

enum class Part : std::uint8_t { Agent, Gateway, Vehicle, UdpStation, TcpStation, Broker };
inline constexpr std::array kParts{Part::Agent, Part::Gateway, Part::Vehicle, Part::UdpStation, Part::TcpStation, Part::Broker};
const char *nameOf(Part part);

class SoakChain
{
public:
    SoakChain();

    void start(Part part);
    /// Kills it, or asks it to end and waits. Returns false if it does not end in order.
    bool end(Part part, bool kill);
    /// 0 if it does not run.
    qint64 pid(Part part) const;
    QByteArray errors(Part part);

    /// Reports of the programs count for missing() from now on.
    void mark();
    /// Which of the parts do not yet work since mark(); empty: all do. Call it again and again: it also reads what arrived.
    QString missing();
    /// The periodic reports of a program since mark(). Not of vehicle and broker.
    std::vector<QJsonObject> stats(Part part) const;

    UdpWire &toGateway() { return m_toGateway; }
    UdpWire &toAgent() { return m_toAgent; }
    FrameTrail &sent() { return m_sent; }
    SoakClient &client() { return m_client; }
    const GatewayFlight &gateway() const { return m_flight; }
    quint16 gatewayPort() const { return m_flight.flight.groundPort; }
    quint16 vehiclePort() const { return m_flight.flight.vehiclePort; }
    quint16 servedPort() const { return m_servedPort; }
    /// Datagrams between agent and gateway, the newest ones.
    std::vector<Bytes> heard();
    KeyUses keyUses();

private:
    Program *program(Part part) const;
    QString missingOf(Part part) const;
    void hear(UdpWire::Way way, ByteView datagram);
    void listen();

    static constexpr std::size_t kHeard = 256;

    Authority m_authority;
    std::unique_ptr<Mosquitto> m_broker;
    const quint16 m_servedPort = freeUdpPort(), m_stationPort = freeUdpPort(), m_tcpPort = freeTcpPort();
    GatewayFlight m_flight;
    FrameTrail m_sent; ///< by the vehicle
    std::mutex m_mutex;
    KeyUses m_keyUses;         ///< under the mutex
    std::deque<Bytes> m_heard; ///< under the mutex
    UdpWire m_toAgent, m_toGateway;
    SoakClient m_client{m_servedPort};
    std::unique_ptr<Program> m_udpStation, m_tcpStation;
    std::unique_ptr<MqttReader> m_reader;
    std::map<Part, std::size_t> m_marks; ///< events before mark()
    bool m_published = false;            ///< the broker passed on a state of the sealed vehicle since mark()
};

} // namespace skyseal::test
