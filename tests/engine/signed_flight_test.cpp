// MAVLink signing between agent and vehicle, over real sockets: what the vehicle signed reaches the ground byte for byte, and
// what has no signature does not. The flight of whole programs is in tests/integration/signing_programs_test.cpp.
#include "core/engine/agent/vehicle_signing.h"
#include "core/mavlink/messages.h"
#include "tests/engine/engine_rigs.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;

namespace {

Key32 theKey()
{
    Key32 key;
    key.mutableView()[3] = 9;
    return key;
}

} // namespace

class SignedFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void framesPassUnchanged();
};

void SignedFlightTest::framesPassUnchanged()
{
    const Introduced keys;
    BareEnd station(keys, channel::Role::Station, everySuite());
    engine::AgentConfig config{
        urlOf("udpin:127.0.0.1:0"), {{urlOf("udpout:127.0.0.1:" + std::to_string(station.port()))}}, everySuite(), false};
    engine::AgentCore agent(
        std::move(config), keys.secrets(channel::Role::Agent), [](const engine::AgentEvent &) {},
        std::make_unique<engine::VehicleSigning>(engine::VehicleKey{theKey(), nullptr}, false));
    agent.start();
    bringUp(station, crypto::SuiteId::ChaCha20Poly1305);
    const Traffic telemetry(256);
    mavlink::FrameSigner signer(theKey(), 4);
    std::vector<Bytes> sent, arrived;
    station.frameReceived = [&arrived](ByteView frame) { arrived.emplace_back(frame.begin(), frame.end()); };
    BareSocket vehicle;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    for (const ByteView frame : telemetry.frames()) {
        const ByteView out = signer.signCopy(frame, buffer);
        sent.emplace_back(out.begin(), out.end());
        vehicle.send(portOf(agent.snapshot().vehicle.localAddress), std::array{out, frame}); // and without a signature
    }
    EVENTUALLY((station.pump(), arrived.size() >= sent.size()));
    QVERIFY(arrived == sent);
    QCOMPARE(agent.snapshot().signing->unsignedRefused, std::uint64_t(256));
}

SKYSEAL_TEST(SignedFlightTest)
#include "signed_flight_test.moc"
