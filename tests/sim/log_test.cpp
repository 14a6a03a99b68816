// Flight logs: what a flight records, in a form that any reader of ArduPilot's logs can read, and their transfer over a link.
#include "tests/sim/test_station.h"
#include "tests/support/test_runner.h"

#include "core/base/byte_reader.h"
#include "core/mavlink/enums.h"
#include "core/sim/flight_logs.h"

#include <QtTest/QTest>

#include <bit>
#include <map>

using namespace skyseal;
using namespace skyseal::sim;
using namespace skyseal::mavlink;
using namespace std::chrono_literals;

class SimLogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noLogsIsOneEntry();
    void eachArmingIsALog();
    void logTellsTheFlight();
    void downloadOverLoss();
    void dataIsPaced();
    void refusals();
    void rangesOutsideTheLog();
    void eraseAndReboot();
    void storeIsBounded();
};

namespace {

constexpr WallTime kBoot{std::chrono::duration_cast<WallTime::duration>(std::chrono::seconds(1'700'000'000))};

SimulatedVehicleConfig atWallTime()
{
    SimulatedVehicleConfig config;
    config.bootTime = kBoot;
    return config;
}

std::vector<LogEntry> list(TestStation &station, std::uint16_t start = 0, std::uint16_t end = 0xffff)
{
    LogRequestList request;
    request.target_system = 1;
    request.target_component = 1;
    request.start = start;
    request.end = end;
    station.forget();
    station.send(request);
    station.run(0.5);
    return station.all<LogEntry>();
}

void request(TestStation &station, std::uint16_t id, std::uint32_t offset, std::uint32_t count)
{
    LogRequestData data;
    data.target_system = 1;
    data.target_component = 1;
    data.id = id;
    data.ofs = offset;
    data.count = count;
    station.send(data);
}

/// The whole log as a station gets it: one request, and others for the gaps.
Bytes download(TestStation &station, const LogEntry &entry)
{
    Bytes bytes(entry.size);
    std::vector<bool> have((entry.size + 89) / 90);
    request(station, entry.id, 0, 0xffffffff);
    for (int tries = 0; tries < 200; ++tries) {
        station.forget();
        station.run(1.5);
        for (const auto &data : station.all<LogData>()) {
            if (data.id != entry.id || data.ofs % 90 != 0 || data.ofs + data.count > entry.size)
                return {};
            std::copy_n(data.data.begin(), data.count, bytes.begin() + data.ofs);
            have[data.ofs / 90] = true;
        }
        if (station.count<LogData>() != 0)
            continue; // it still sends
        const auto gap = std::find(have.begin(), have.end(), false);
        if (gap == have.end())
            return bytes;
        request(station, entry.id, static_cast<std::uint32_t>(gap - have.begin()) * 90, 900);
    }
    return {};
}

struct Record
{
    std::string name;
    std::map<std::string, double> numbers; ///< in the log's units: hundredths are divided
    std::map<std::string, std::string> texts;
};

/// Reads a log by its own FMT records, as a stranger's reader does; empty if a byte is left over.
std::vector<Record> parse(ByteView log)
{
    struct Format
    {
        std::size_t length;
        std::string name, letters;
        std::vector<std::string> columns;
    };
    std::map<int, Format> formats{{128, {89, "FMT", "BBnNZ", {"Type", "Length", "Name", "Format", "Columns"}}}};
    std::vector<Record> records;
    ByteReader in(log);
    while (!in.atEnd()) {
        const std::size_t start = in.position();
        if (in.u16() != 0x95a3)
            return {};
        const auto format = formats.find(in.u8());
        if (format == formats.end())
            return {};
        Record record{format->second.name, {}, {}};
        const auto text = [&](std::size_t size) {
            const ByteView raw = in.bytes(size);
            std::string value(raw.begin(), raw.end());
            return value.substr(0, value.find('\0'));
        };
        for (std::size_t i = 0; i < format->second.letters.size(); ++i) {
            const std::string &column = format->second.columns[i];
            switch (format->second.letters[i]) {
            case 'Q': record.numbers[column] = static_cast<double>(in.u64()); break;
            case 'I': record.numbers[column] = in.u32(); break;
            case 'H': record.numbers[column] = in.u16(); break;
            case 'B':
            case 'M': record.numbers[column] = in.u8(); break;
            case 'c': record.numbers[column] = in.littleEndian<std::int16_t>() / 100.0; break;
            case 'C': record.numbers[column] = in.u16() / 100.0; break;
            case 'e': record.numbers[column] = in.littleEndian<std::int32_t>() / 100.0; break;
            case 'L': record.numbers[column] = in.littleEndian<std::int32_t>() * 1e-7; break;
            case 'f': record.numbers[column] = static_cast<double>(std::bit_cast<float>(in.u32())); break;
            case 'n': record.texts[column] = text(4); break;
            case 'N': record.texts[column] = text(16); break;
            case 'Z': record.texts[column] = text(64); break;
            default: return {};
            }
        }
        if (!in.ok() || in.position() - start != format->second.length)
            return {};
        if (record.name == "FMT") {
            Format &added = formats[static_cast<int>(record.numbers["Type"])];
            added = {static_cast<std::size_t>(record.numbers["Length"]), record.texts["Name"], record.texts["Format"], {}};
            std::string columns = record.texts["Columns"] + ",";
            for (std::size_t at; (at = columns.find(',')) != std::string::npos; columns.erase(0, at + 1))
                added.columns.push_back(columns.substr(0, at));
            if (added.columns.size() != added.letters.size())
                return {};
        }
        records.push_back(std::move(record));
    }
    return records;
}

bool hop(TestStation &station)
{
    return station.takeOff(5) && station.command(MAV_CMD_NAV_LAND) == MAV_RESULT_ACCEPTED
        && station.until([&] { return !station.vehicle.autopilot().armed(); }, 60);
}

} // namespace

void SimLogTest::noLogsIsOneEntry()
{
    TestStation station;
    station.run(1);
    const auto entries = list(station);
    QCOMPARE(entries.size(), std::size_t(1));
    QCOMPARE(int(entries[0].id), 0);
    QCOMPARE(int(entries[0].num_logs), 0);
    QCOMPARE(int(entries[0].last_log_num), 0);
    QCOMPARE(entries[0].size, 0u);
}

void SimLogTest::eachArmingIsALog()
{
    TestStation station(atWallTime());
    station.run(6);
    for (int i = 0; i < 3; ++i) {
        QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
        station.run(2 + i);
        QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0}), int(MAV_RESULT_ACCEPTED));
        station.run(10);
    }
    const auto entries = list(station);
    QCOMPARE(entries.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(std::size_t(entries[i].id), i + 1);
        QCOMPARE(int(entries[i].num_logs), 3);
        QCOMPARE(int(entries[i].last_log_num), 3);
        QVERIFY(i == 0 || entries[i].size > entries[i - 1].size); // it was armed longer
    }
    QVERIFY(std::abs(double(entries[0].time_utc) - 1'700'000'006) <= 1);
    QVERIFY(std::abs(double(entries[2].time_utc) - 1'700'000'031) <= 1);
    const auto second = list(station, 2, 2);
    QCOMPARE(second.size(), std::size_t(1));
    QCOMPARE(int(second[0].id), 2);
    QCOMPARE(list(station, 4, 9).size(), std::size_t(0));
    QCOMPARE(list(station, 3, 2).size(), std::size_t(0));
}

void SimLogTest::logTellsTheFlight()
{
    TestStation station(atWallTime());
    QVERIFY(hop(station));
    station.run(1);
    const auto entries = list(station);
    QCOMPARE(entries.size(), std::size_t(1));
    const auto records = parse(download(station, entries[0]));
    QVERIFY(!records.empty());
    std::map<std::string, int> count;
    double highest = 0, last = 0;
    std::vector<int> events, modes;
    for (const Record &record : records) {
        ++count[record.name];
        const auto &n = record.numbers;
        if (n.contains("TimeUS")) {
            QVERIFY(n.at("TimeUS") >= last);
            last = n.at("TimeUS");
        }
        if (record.name == "POS") {
            highest = std::max(highest, n.at("RelHomeAlt"));
            QVERIFY(std::abs(n.at("Lat") + 35.363261) < 1e-4 && std::abs(n.at("Lng") - 149.165230) < 1e-4);
        } else if (record.name == "EV") {
            events.push_back(static_cast<int>(n.at("Id")));
        } else if (record.name == "MODE") {
            modes.push_back(static_cast<int>(n.at("ModeNum")));
        } else if (record.name == "GPS") {
            QCOMPARE(n.at("Status"), 3.0);
            QCOMPARE(n.at("GWk"), 2288.0); // 1,700,000,000 s of unix time, in November 2023
        } else if (record.name == "PARM" && record.texts.at("Name") == "RTL_ALT") {
            QCOMPARE(n.at("Value"), 1500.0);
        } else if (record.name == "BAT") {
            QVERIFY(n.at("Volt") > 11 && n.at("Volt") < 12.7 && n.at("RemPct") > 90);
        } else if (record.name == "ATT") {
            QVERIFY(std::abs(n.at("Roll")) < 30 && n.at("Yaw") >= 0 && n.at("Yaw") < 360);
        }
    }
    QVERIFY2(highest > 4.7 && highest < 5.5, qPrintable(QString::number(highest)));
    QCOMPARE(events, (std::vector<int>{10, 28, 18, 11})); // armed, off the ground, on it, disarmed
    QCOMPARE(modes, (std::vector<int>{4, 9}));
    QCOMPARE(std::size_t(count["PARM"]), station.vehicle.autopilot().parameters().count());
    QVERIFY(count["ATT"] > 150 && count["POS"] == count["ATT"] && count["GPS"] > 70 && count["BAT"] > 15);
}

void SimLogTest::downloadOverLoss()
{
    TestStation clean(atWallTime());
    QVERIFY(hop(clean));
    clean.run(1);
    const Bytes whole = download(clean, list(clean).at(0));
    QVERIFY(whole.size() > 20000);
    QVERIFY(!parse(whole).empty());

    SimulatedVehicleConfig config = atWallTime();
    TestStation station(config, 0.2, 3);
    station.run(6);
    while (!station.vehicle.autopilot().armed())
        station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1});
    station.run(2);
    while (station.vehicle.autopilot().armed())
        station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0});
    station.run(1);
    std::vector<LogEntry> entries;
    while (entries.empty())
        entries = list(station);
    const Bytes bytes = download(station, entries[0]);
    QCOMPARE(bytes.size(), std::size_t(entries[0].size));
    QVERIFY(!parse(bytes).empty());
}

void SimLogTest::dataIsPaced()
{
    TestStation station;
    QVERIFY(hop(station));
    station.run(1);
    const auto entries = list(station);
    station.forget();
    request(station, 1, 0, 0xffffffff);
    station.run(0.1);
    QVERIFY2(station.count<LogData>() <= 26, qPrintable(QString::number(station.count<LogData>()))); // one each 4 ms
    QVERIFY(station.count<LogData>() >= 20);
    request(station, 1, 0, 0xffffffff); // while it sends: does not begin again
    station.run(0.1);
    const auto all = station.all<LogData>();
    for (std::size_t i = 0; i < all.size(); ++i)
        QCOMPARE(std::size_t(all[i].ofs), i * 90);
    station.until([&] { return station.last<LogData>().ofs + station.last<LogData>().count == entries[0].size; }, 20);
    QCOMPARE(station.vehicle.dropped(), std::uint64_t(0));
    QVERIFY(station.count<mavlink::Heartbeat>() >= 1); // telemetry went on

    request(station, 1, 0, 0xffffffff);
    station.run(0.1);
    LogRequestEnd end;
    end.target_system = 1;
    end.target_component = 1;
    station.send(end);
    station.forget();
    station.run(1);
    QCOMPARE(station.count<LogData>(), std::size_t(0));
}

void SimLogTest::refusals()
{
    TestStation station;
    QVERIFY(hop(station));
    station.run(1);
    request(station, 1, 0, 0xffffffff);
    station.run(0.05);
    station.writer = FrameWriter(200, 190); // another station
    request(station, 1, 0, 900);
    station.run(0.1);
    QVERIFY(station.said("Log download in progress"));
    station.writer = FrameWriter(255, 190);

    QCOMPARE(station.command(MAV_CMD_DO_SET_MODE, {1, 0}), int(MAV_RESULT_ACCEPTED));
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {1}), int(MAV_RESULT_ACCEPTED));
    station.forget();
    station.run(2);
    QCOMPARE(station.count<LogData>(), std::size_t(0)); // waits
    QCOMPARE(list(station).size(), std::size_t(0));
    station.run(0.1);
    QVERIFY(station.said("Disarm for log download"));
    LogErase erase;
    erase.target_system = 1;
    erase.target_component = 1;
    station.send(erase);
    QCOMPARE(station.command(MAV_CMD_COMPONENT_ARM_DISARM, {0}), int(MAV_RESULT_ACCEPTED));
    station.run(2);
    QVERIFY(station.count<LogData>() > 0); // goes on
    QVERIFY(station.until(
        [&, before = std::size_t(0)]() mutable {
            const std::size_t now = station.count<LogData>();
            station.run(0.1);
            return std::exchange(before, station.count<LogData>()) == now;
        },
        20));
    QCOMPARE(list(station).size(), std::size_t(2)); // nothing was erased
}

void SimLogTest::rangesOutsideTheLog()
{
    TestStation station;
    QVERIFY(hop(station));
    station.run(1);
    const auto size = list(station).at(0).size;
    const auto ask = [&](std::uint16_t id, std::uint32_t offset, std::uint32_t count) {
        station.forget();
        request(station, id, offset, count);
        station.run(0.3);
        return station.all<LogData>();
    };
    auto data = ask(1, size - 10, 900);
    QCOMPARE(data.size(), std::size_t(1));
    QCOMPARE(int(data[0].count), 10);
    for (const std::uint32_t offset : {size, size + 1, 0xffffffffu}) { // an empty one tells the end
        data = ask(1, offset, 90);
        QCOMPARE(data.size(), std::size_t(1));
        QCOMPARE(int(data[0].count), 0);
    }
    QCOMPARE(ask(1, 0, 0).size(), std::size_t(1));
    QCOMPARE(ask(0, 0, 90).size(), std::size_t(0));
    QCOMPARE(ask(2, 0, 90).size(), std::size_t(0));
    QCOMPARE(ask(0xffff, 0, 90).size(), std::size_t(0));
    QCOMPARE(ask(1, 7, 90).at(0).ofs, 7u);
}

void SimLogTest::eraseAndReboot()
{
    TestStation station;
    QVERIFY(hop(station));
    station.run(1);
    QCOMPARE(station.command(MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, {1}), int(MAV_RESULT_ACCEPTED));
    station.run(2);
    QCOMPARE(list(station).at(0).num_logs, std::uint16_t(1));
    request(station, 1, 0, 0xffffffff);
    LogErase erase;
    erase.target_system = 1;
    erase.target_component = 1;
    station.send(erase);
    station.run(0.2);
    QCOMPARE(list(station).at(0).num_logs, std::uint16_t(0));
}

void SimLogTest::storeIsBounded()
{
    FlightLogs logs;
    for (std::uint32_t i = 0; i < 50; ++i) {
        logs.begin(i);
        const Bytes record(1000);
        for (int k = 0; k < 1000; ++k)
            logs.append(record);
        logs.end();
        logs.append(record);
        QVERIFY(logs.count() <= FlightLogs::kMost);
        QCOMPARE(logs.log(logs.count() - 1).bytes.size(), FlightLogs::kMostBytes / 1000 * 1000);
    }
    QCOMPARE(logs.log(0).startedAt, 44u);
    QCOMPARE(logs.log(5).number, 50u);
    logs.begin(0);
    logs.remove(logs.count() - 1); // the one that is being written
    const Bytes record(10);
    logs.append(record);
    QCOMPARE(logs.log(logs.count() - 1).bytes.size(), FlightLogs::kMostBytes / 1000 * 1000);
}

SKYSEAL_TEST_APPLESS(SimLogTest)
#include "log_test.moc"
