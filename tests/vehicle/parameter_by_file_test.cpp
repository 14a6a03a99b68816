// The list of parameters as one file by MAVLink FTP: from a scripted autopilot and from the simulated vehicle, through a radio
// that drops, and the way back to PARAM_REQUEST_LIST.
#include "core/mavlink/packed_parameters.h"
#include "core/sim/simulated_vehicle.h"
#include "core/vehicle/parameter_client.h"
#include "core/vehicle/time_sync_client.h"
#include "ftp_peer.h"
#include "parameter_peer.h"
#include "tests/support/test_runner.h"
#include "transfer_measure.h"

#include <bit>

using namespace skyseal;
using namespace skyseal::vehicle;

class ParameterByFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fileReplacesTheList();
    void vehicleWithoutTheFileIsAskedForTheList_data();
    void vehicleWithoutTheFileIsAskedForTheList();
    void silenceCostsLittleTime();
    void outageIsNoProofThatThereIsNoFile();
    void filesUnderWayAreNotDisturbed();
    void damagedFilesAreNotTaken_data();
    void damagedFilesAreNotTaken();
    void simulatedVehicleServesIt();
    void lossCostsLittleTime_data();
    void lossCostsLittleTime();
};

namespace {

constexpr std::uint16_t kCount = 915; // as many as ArduCopter has

/// Writes the format from its description, with the padding that keeps a value within a chunk.
Bytes packed(std::uint16_t count)
{
    Bytes out;
    const auto number = [&out](std::uint32_t value, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i)
            out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    number(0x671b, 2);
    number(count, 2);
    number(count, 2);
    std::string last;
    for (std::uint16_t i = 0; i < count; ++i) {
        const std::string name = nameOf(i);
        std::size_t shared = 0;
        while (shared + 1 < name.size() && shared < last.size() && name[shared] == last[shared])
            ++shared;
        const std::size_t end = out.size() + 2 + (name.size() - shared) + 4, past = end % FtpMessage::kMostData;
        if (past > 0 && past < 4)
            out.resize(out.size() + 4 - past);
        out.push_back(4); // a float
        out.push_back(static_cast<std::uint8_t>(shared | (name.size() - shared - 1) << 4));
        out.insert(out.end(), name.begin() + static_cast<std::ptrdiff_t>(shared), name.end());
        number(std::bit_cast<std::uint32_t>(i * 0.5f), 4);
        last = name;
    }
    return out;
}

/// Serves the file, and the list.
class FilePeer : public ScriptedPeer
{
public:
    FilePeer()
    {
        files.files[ParameterClient::kFile] = packed(kCount);
        files.announced = kCount * 12u;             // an estimate
        files.pace = std::chrono::milliseconds(10); // 24 kB a second, as the simulated vehicle
    }

    FtpPeer files;
    PacedPeer list{kCount, std::chrono::microseconds(546)}; // 1,830 a second, as ArduCopter in SITL
    bool answersFtp = true;
    int lists = 0;

    void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) override
    {
        lists += as<mavlink::ParamRequestList>(message).has_value();
        if (answersFtp)
            files.handle(now, message, out);
        list.handle(now, message, out);
    }
    void handleDeadline(TimePoint now, std::vector<ToStation> &out) override
    {
        if (files.nextDeadline() <= now)
            files.handleDeadline(now, out);
        if (list.nextDeadline() <= now)
            list.handleDeadline(now, out);
    }
    TimePoint nextDeadline() const override { return std::min(files.nextDeadline(), list.nextDeadline()); }
};

Harness copterWithFiles()
{
    Harness out = Harness::copter();
    out.feed(mavlink::AutopilotVersion{.capabilities = mavlink::MAV_PROTOCOL_CAPABILITY_FTP});
    out.runUntil(out.now);
    out.sent();
    out.runUntil(out.now + TimeSyncClient::kInterval);
    for (const mavlink::Timesync &sync : out.sentOf<mavlink::Timesync>()) { // the round trip is known
        out.now += std::chrono::milliseconds(50);
        out.feed(mavlink::Timesync{.tc1 = 1, .ts1 = sync.ts1});
    }
    return out;
}

std::optional<ParameterResult> read(Harness &h, LossyLink &link, Duration limit = std::chrono::seconds(60))
{
    std::optional<ParameterResult> result;
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    link.run(limit, [&] { return (result = h.poll<ParameterResult>()).has_value(); });
    return result;
}

bool hasAll(const std::optional<ParameterResult> &result)
{
    if (!result || !result->ok || !result->all || result->all->size() != kCount)
        return false;
    return std::ranges::all_of(*result->all, [](const Parameter &parameter) {
        return parameter.name == nameOf(parameter.index) && parameter.value == parameter.index * 0.5;
    });
}

/// A vehicle of the simulator at the other end of the link.
class SimulatedPeer : public ScriptedPeer
{
public:
    explicit SimulatedPeer(TimePoint now) : m_vehicle({}, now) {}

    void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) override
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const auto bytes = m_writer.write(message.id, message.crcExtra, message.minLength, message.view(), buffer);
        m_vehicle.handleFrame(now, *mavlink::readFrame(bytes, mavlink::Dialect::builtin()));
        drain(out);
    }
    void handleDeadline(TimePoint now, std::vector<ToStation> &out) override
    {
        m_vehicle.advance(now);
        drain(out);
    }
    TimePoint nextDeadline() const override { return m_vehicle.nextDeadline(); }
    const sim::Parameters &parameters() const { return m_vehicle.autopilot().parameters(); }

private:
    void drain(std::vector<ToStation> &out)
    {
        for (ByteView frame = m_vehicle.pollFrame(); !frame.empty(); frame = m_vehicle.pollFrame()) {
            out.push_back([bytes = Bytes(frame.begin(), frame.end())](Harness &harness) {
                harness.vehicle.handleFrame(harness.now, {}, *mavlink::readFrame(bytes, mavlink::Dialect::builtin()));
            });
        }
    }

    sim::SimulatedVehicle m_vehicle;
    mavlink::FrameWriter m_writer{255, 190};
};

} // namespace

void ParameterByFileTest::fileReplacesTheList()
{
    Harness h = copterWithFiles();
    FilePeer peer;
    QVERIFY(peer.files.files[ParameterClient::kFile].size() > *peer.files.announced);
    LossyLink link(h, peer, 0, 1);
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    link.run(std::chrono::milliseconds(150), [] { return false; });
    const auto transfers = h.vehicle.state(h.now).transfers;
    QCOMPARE(transfers.size(), std::size_t(1));
    QCOMPARE(transfers[0].id, RequestId{1});
    QVERIFY(transfers[0].done > 0 && transfers[0].total >= transfers[0].done);
    std::optional<ParameterResult> result;
    link.run(std::chrono::seconds(60), [&] { return (result = h.poll<ParameterResult>()).has_value(); });
    QVERIFY(hasAll(result));
    QCOMPARE(peer.lists, 0);
    QCOMPARE(peer.files.sessions, 0); // it is closed
    QCOMPARE(h.vehicle.parametersExpected(), std::uint32_t(kCount));
    QVERIFY(!h.poll<FileResult>()); // nobody asked for a file
    QVERIFY(h.vehicle.state(h.now).transfers.empty());
    QVERIFY(hasAll(read(h, link))); // and again
    QCOMPARE(peer.lists, 0);
}

void ParameterByFileTest::vehicleWithoutTheFileIsAskedForTheList_data()
{
    QTest::addColumn<bool>("hasCapability");
    QTest::addColumn<bool>("isPx4");
    QTest::newRow("without the capability") << false << false;
    QTest::newRow("without the file") << true << false;
    QTest::newRow("of another autopilot") << true << true;
}

void ParameterByFileTest::vehicleWithoutTheFileIsAskedForTheList()
{
    QFETCH(bool, hasCapability);
    QFETCH(bool, isPx4);
    Harness h = isPx4 ? Harness::px4() : Harness::copter();
    if (hasCapability)
        h.feed(mavlink::AutopilotVersion{.capabilities = mavlink::MAV_PROTOCOL_CAPABILITY_FTP});
    FilePeer peer;
    peer.files.files.clear();
    LossyLink link(h, peer, 0, 1);
    h.vehicle.perform(h.now, RequestId{1}, ReadParameters{});
    link.run(std::chrono::milliseconds(60), [] { return false; }); // a round trip later at the most
    QCOMPARE(peer.lists, 1);
    link.run(std::chrono::seconds(10), [&] { return h.poll<ParameterResult>().has_value(); });
    QCOMPARE(h.vehicle.parameters()->size(), std::size_t(kCount));
}

void ParameterByFileTest::silenceCostsLittleTime()
{
    Harness h = copterWithFiles();
    FilePeer peer;
    peer.answersFtp = false;
    LossyLink link(h, peer, 0, 1);
    TimePoint begin = h.now;
    QVERIFY(hasAll(read(h, link)));
    QVERIFY(h.now < begin + ParameterClient::kOpenTimeout + std::chrono::seconds(1));
    begin = h.now;
    QVERIFY(hasAll(read(h, link))); // the vehicle is not asked again
    QVERIFY(h.now < begin + std::chrono::seconds(1));
    QCOMPARE(peer.lists, 2);
}

void ParameterByFileTest::outageIsNoProofThatThereIsNoFile()
{
    Harness h = copterWithFiles();
    FilePeer peer;
    peer.files.burstLength = 10;
    LossyLink link(h, peer, 0, 1);
    link.addOutage(h.now + std::chrono::milliseconds(150), h.now + std::chrono::seconds(30));
    const auto failed = read(h, link);
    QVERIFY(failed && !failed->ok);
    link.run(std::chrono::seconds(40), [] { return false; });
    const int lists = peer.lists;
    QVERIFY(hasAll(read(h, link)));
    QCOMPARE(peer.lists, lists);
}

void ParameterByFileTest::filesUnderWayAreNotDisturbed()
{
    Harness h = copterWithFiles();
    FilePeer peer;
    peer.files.files["/log.bin"] = Bytes(100'000, 7);
    LossyLink link(h, peer, 0, 1);
    h.vehicle.perform(h.now, RequestId{5}, vehicle::ReadFile{"/log.bin"});
    QVERIFY(hasAll(read(h, link)));
    QCOMPARE(peer.lists, 1);
    std::optional<FileResult> file;
    QVERIFY(link.run(std::chrono::seconds(60), [&] { return (file = h.poll<FileResult>()).has_value(); }));
    QVERIFY(file->ok && file->id == RequestId{5});
    QVERIFY(hasAll(read(h, link)));
    QCOMPARE(peer.lists, 1); // now by the file
}

void ParameterByFileTest::damagedFilesAreNotTaken_data()
{
    QTest::addColumn<int>("place");
    QTest::addColumn<int>("content");
    QTest::newRow("magic") << 0 << 0;
    QTest::newRow("fewer than there are") << 2 << 10;
    QTest::newRow("not all of the vehicle") << 4 << 0x94;
    QTest::newRow("type") << 6 << 9;
    QTest::newRow("length of a name") << 7 << 0xf7;
    QTest::newRow("cut") << -1 << 0;
}

void ParameterByFileTest::damagedFilesAreNotTaken()
{
    QFETCH(int, place);
    QFETCH(int, content);
    Harness h = copterWithFiles();
    FilePeer peer;
    Bytes &file = peer.files.files[ParameterClient::kFile];
    if (place < 0)
        file.pop_back();
    else
        file[static_cast<std::size_t>(place)] = static_cast<std::uint8_t>(content);
    LossyLink link(h, peer, 0, 1);
    QVERIFY(hasAll(read(h, link)));
    QCOMPARE(peer.lists, 1);
}

void ParameterByFileTest::simulatedVehicleServesIt()
{
    Harness h = copterWithFiles();
    SimulatedPeer peer(h.now);
    LossyLink link(h, peer, 0, 1, std::chrono::milliseconds(25));
    const auto result = read(h, link);
    QVERIFY(result && result->ok);
    QCOMPARE(result->all->size(), peer.parameters().count());
    for (const Parameter &parameter : *result->all) {
        QCOMPARE(parameter.name, std::string(peer.parameters().info(parameter.index).name));
        QCOMPARE(parameter.value, static_cast<double>(peer.parameters().value(parameter.index)));
    }
}

void ParameterByFileTest::lossCostsLittleTime_data()
{
    QTest::addColumn<bool>("isSimulated");
    QTest::newRow("915 parameters") << false;
    QTest::newRow("the simulated vehicle") << true;
}

/// 25 ms each way.
void ParameterByFileTest::lossCostsLittleTime()
{
    QFETCH(bool, isSimulated);
    const auto timeToRead = [isSimulated](double loss, unsigned seed) {
        Harness h = copterWithFiles();
        std::unique_ptr<ScriptedPeer> peer;
        if (isSimulated)
            peer = std::make_unique<SimulatedPeer>(h.now);
        else
            peer = std::make_unique<FilePeer>();
        LossyLink link(h, *peer, loss, seed, std::chrono::milliseconds(25));
        const TimePoint begin = h.now;
        const auto result = read(h, link);
        const bool ok = isSimulated ? result && result->ok : hasAll(result);
        return ok ? seconds(h.now - begin) : 60.;
    };
    const double clean = timeToRead(0, 1);
    QVERIFY2(clean < 1, std::to_string(clean).c_str()); // the list: half a second at 1,830 a second
    verifyCostOfLoss(timeToRead, clean);
}

SKYSEAL_TEST_APPLESS(ParameterByFileTest)
#include "parameter_by_file_test.moc"
