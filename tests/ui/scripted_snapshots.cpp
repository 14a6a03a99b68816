#include "scripted_snapshots.h"

#include "core/log/log_index.h"
#include "core/mavlink/enums.h"
#include "core/vehicle/flight_modes.h"

#include <cmath>
#include <numbers>

namespace skyseal::ui {

using crypto::SuiteId;
using std::numbers::pi;

namespace {

constexpr double kHomeLatitude = 47.3977, kHomeLongitude = 8.5456;
constexpr double kRadius = 48, kTurn = 0.12; ///< metres, radians a second

std::shared_ptr<const std::vector<vehicle::MissionItem>> mission()
{
    static const auto items = [] {
        auto out = std::make_shared<std::vector<vehicle::MissionItem>>();
        out->push_back({});
        const double corners[][2] = {{0.0006, 0.0002}, {0.0008, 0.0012}, {0.0001, 0.0014}, {-0.0003, 0.0006}};
        for (const auto &[north, east] : corners) {
            vehicle::MissionItem item;
            item.sequence = static_cast<std::uint16_t>(out->size());
            item.latitude = kHomeLatitude + north;
            item.longitude = kHomeLongitude + east;
            item.altitude = 20;
            out->push_back(item);
        }
        return out;
    }();
    return items;
}

std::shared_ptr<const std::vector<vehicle::Parameter>> parameters()
{
    static const auto all = [] {
        auto out = std::make_shared<std::vector<vehicle::Parameter>>();
        const std::pair<const char *, double> some[] = {
            {"ACRO_YAW_P", 4.5},  {"ARMING_CHECK", 1},   {"BATT_CAPACITY", 3300}, {"FENCE_ALT_MAX", 100},
            {"FS_GCS_ENABLE", 1}, {"FS_THR_VALUE", 975}, {"LAND_SPEED", 50},      {"PILOT_SPEED_UP", 250},
            {"RTL_ALT", 1500},    {"SYSID_MYGCS", 255},  {"WPNAV_ACCEL", 100},    {"WPNAV_SPEED", 500}};
        for (const auto &[name, value] : some)
            out->push_back({name, value, 9, static_cast<std::uint16_t>(out->size())});
        return out;
    }();
    return all;
}

} // namespace

void enterMode(vehicle::VehicleState &state, const std::string &name)
{
    state.mode = name;
    const auto number = vehicle::modeNumber({state.type, state.autopilot}, name);
    state.customMode = number.value_or(0);
    state.baseMode = number ? mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED : 0;
}

namespace {

vehicle::VehicleState flyingState(double time)
{
    vehicle::VehicleState s;
    const double angle = time * kTurn;
    s.systemId = 1;
    s.type = mavlink::MAV_TYPE_QUADROTOR;
    s.autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
    enterMode(s, "GUIDED");
    s.modes = {"STABILIZE", "ALT_HOLD", "AUTO", "GUIDED", "LOITER", "RTL", "LAND"};
    s.armed = true;
    s.roll = 0.14 + 0.02 * std::sin(time * 1.3);
    s.pitch = -0.05 + 0.03 * std::sin(time * 0.7);
    s.heading = std::fmod(angle * 180 / pi + 90, 360);
    s.yaw = s.heading * pi / 180;
    const double north = kRadius * std::cos(angle), east = kRadius * std::sin(angle);
    s.position = {kHomeLatitude + north / 111319.5, kHomeLongitude + east / (111319.5 * std::cos(kHomeLatitude * pi / 180)),
                  500};
    s.home = {kHomeLatitude, kHomeLongitude, 488};
    s.altitudeRelative = 12.4 + std::sin(time * 0.2) * 2;
    s.groundSpeed = 5.8 + 0.2 * std::sin(time);
    s.climb = 0.4 * std::cos(time * 0.2);
    s.throttle = 41;
    s.distanceHome = kRadius;
    s.flightTime = 201 + time;
    s.batteryVoltage = 15.8 - time * 0.001;
    s.batteryCurrent = 11.2 + std::sin(time * 2);
    s.batteryPercent = 78 - time * 0.02;
    s.gpsFix = 3;
    s.satellites = 12;
    s.hdop = 0.8;
    s.ekfOk = true;
    s.missionCurrent = 2;
    s.latency = 0.012;
    s.firmware = "ArduCopter 4.5.7";
    s.heartbeatAge = 0.4;
    s.messageAge = 0.02;
    return s;
}

engine::LinkSnapshot listeningLink()
{
    engine::LinkSnapshot link;
    link.id = LinkId{1};
    link.url = "udpin:0.0.0.0:14550";
    link.phase = engine::LinkPhase::Listening;
    link.localAddress = "0.0.0.0:14550";
    return link;
}

engine::InspectorRow inspectorRow(std::uint32_t id, const char *name, std::uint64_t count, double rate, std::uint8_t size)
{
    engine::InspectorRow row;
    row.messageId = id;
    row.name = name;
    row.systemId = 1;
    row.componentId = 1;
    row.count = count;
    row.rate = rate;
    row.payloadSize = size;
    return row;
}

} // namespace

std::vector<SuiteId> usualSuites()
{
    return {SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm, SuiteId::Aes256Ctr, SuiteId::Aes256Cbc, SuiteId::ChaCha20};
}

engine::Snapshot waitingSnapshot()
{
    engine::Snapshot snapshot;
    snapshot.links.push_back(listeningLink());
    return snapshot;
}

engine::Snapshot pendingApprovalSnapshot()
{
    engine::Snapshot snapshot = waitingSnapshot();
    snapshot.security = engine::Security::Plain;
    snapshot.pendingApproval.push_back({1, "192.0.2.66:40000", "air-1"});
    return snapshot;
}

engine::Snapshot plainSnapshot(double time)
{
    engine::Snapshot snapshot = waitingSnapshot();
    snapshot.number = static_cast<std::uint64_t>(time * 30) + 1;
    snapshot.time = time;
    snapshot.security = engine::Security::Plain;
    auto &link = snapshot.links.front();
    link.remoteAddress = "127.0.0.1:41234";
    link.rxBytesPerSecond = 3200 + 90 * std::sin(time);
    link.txBytesPerSecond = 130;
    link.rxBytes = 1234567;
    engine::VehicleSnapshot vehicle;
    vehicle.state = flyingState(time);
    vehicle.link = link.id;
    vehicle.framesPerSecond = 62;
    vehicle.lossPercent = 0.2;
    vehicle.mission = mission();
    vehicle.parameters = parameters();
    vehicle.parametersExpected = 12;
    snapshot.vehicles.push_back(std::move(vehicle));
    snapshot.recording = {true, "flight.tlog", 12'300'000, 180'000, 0, {}};
    snapshot.processCpuPercent = 3.1;
    snapshot.residentBytes = 92'000'000;
    snapshot.inspector = {inspectorRow(0, "HEARTBEAT", 812, 1, 9),
                          inspectorRow(30, "ATTITUDE", 8120, 10, 28),
                          inspectorRow(33, "GLOBAL_POSITION_INT", 2436, 3, 28),
                          inspectorRow(1, "SYS_STATUS", 1624, 2, 31),
                          inspectorRow(74, "VFR_HUD", 8120, 10, 20),
                          inspectorRow(24, "GPS_RAW_INT", 1624, 2, 30)};
    return snapshot;
}

engine::Snapshot sealedSnapshot(double time, SuiteId suite, std::uint32_t epoch)
{
    engine::Snapshot snapshot = plainSnapshot(time);
    snapshot.security = engine::Security::Sealed;
    engine::SessionSnapshot session;
    session.info.session = channel::SessionId{7};
    session.info.peerName = "air-1";
    session.info.suite = suite;
    session.info.epoch = channel::Epoch{epoch};
    session.info.permitted = usualSuites();
    session.info.peerOffered = usualSuites();
    session.stats.rx.good = 12034 + static_cast<std::uint64_t>(time * 50);
    session.stats.rx.late = 3;
    session.stats.rx.lost = 12;
    session.stats.peerReported = true;
    session.stats.peerRx.good = 1204;
    session.stats.peerRx.lost = 1;
    session.stats.roundTrip = std::chrono::milliseconds(12);
    session.fingerprint = "41c0 9be7 d3f2 0a5e 77b1 c864 2f9d e013 5a88 b6cc 1d40 93fe 08a7 64b5 e2d9 3c71";
    session.remoteAddress = "127.0.0.1:41234";
    session.age = 120 + time;
    session.lossPercent = 0.2;
    snapshot.vehicles.front().session = session.info.session;
    snapshot.sessions.push_back(std::move(session));
    return snapshot;
}

engine::Snapshot replayedSnapshot(double position)
{
    using namespace std::chrono_literals;
    static const auto index = [] {
        auto out = std::make_shared<tlog::LogIndex>();
        out->first = WallTime(std::chrono::seconds(1'777'716'000));
        out->length = 900s;
        out->frames = 54'000;
        out->vehicles = {1};
        const std::pair<Duration, std::uint32_t> modes[] = {{0s, 0}, {55s, 4}, {80s, 3}, {640s, 6}, {760s, 9}};
        for (const auto &[at, mode] : modes)
            out->modes.push_back({at, 1, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA, 1, mode});
        out->armed.push_back({{60s, 815s}, 1});
        out->gaps.push_back({400s, 455s});
        using enum tlog::LinkEvent::Kind;
        out->suites = {{0s, {Sealed, *out->first, "chacha20-poly1305", "air-1"}},
                       {500s, {Switched, *out->first + 500s, "aes-256-gcm", "air-1"}},
                       {700s, {Switched, *out->first + 700s, "chacha20-poly1305", "air-1"}}};
        return out;
    }();
    engine::Snapshot out = plainSnapshot(position);
    enterMode(out.vehicles.front().state, "AUTO");
    out.links.front().url = "tlog:/logs/2026-05-02 field.tlog";
    out.links.front().recording = true;
    engine::ReplayStatus status;
    status.position = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(position));
    status.time = *index->first + std::chrono::floor<std::chrono::microseconds>(status.position);
    status.playing = true;
    status.index = index;
    out.replay = status;
    return out;
}

std::vector<engine::MetricsSample> samplesOf(std::uint64_t firstNumber, double fromTime, double toTime, SuiteId suite,
                                             std::uint32_t epoch)
{
    std::vector<engine::MetricsSample> out;
    const double cost = 1 + 0.35 * static_cast<double>(suite);
    for (double t = fromTime; t < toTime - 1e-9; t += 0.25) {
        engine::MetricsSample s;
        s.number = firstNumber + out.size();
        s.time = t;
        s.suite = suite;
        s.epoch = epoch;
        s.linkUp = true;
        const double wobble = std::sin(t * 1.7) + 0.5 * std::sin(t * 5.1);
        s.openedFramesPerSecond = 62 + wobble * 1.5;
        s.openedBytesPerSecond = s.openedFramesPerSecond * 41;
        s.lossPercent = std::max(0.0, 0.4 + 0.4 * std::sin(t * 0.6));
        s.peerLossPercent = std::max(0.0, 0.1 + 0.2 * std::sin(t * 0.4));
        s.processCpuPercent = 3 + 0.3 * wobble;
        s.suiteCpuPercent = 0.25 * cost + 0.05 * wobble;
        s.ioCpuPercent = 1 + 0.1 * wobble;
        s.openNsP50 = 6000 + 260 * cost;
        s.openNsP99 = 9000 + 410 * cost;
        s.openNextNsP50 = 260 * cost;
        s.openNextNsP99 = 410 * cost;
        s.sealNsP50 = 2000 + 240 * cost;
        s.sealNsP99 = 4000 + 390 * cost;
        s.mavlinkLossPercent = s.lossPercent * 1.2;
        s.peerMavlinkLossPercent = s.peerLossPercent * 1.3;
        s.powerWatts = 14 + wobble;
        s.latency = 0.012 + 0.001 * wobble;
        s.roundTrip = 0.008 + 0.001 * wobble;
        s.rxOverheadPercent = 55;
        s.txOverheadPercent = 80;
        s.rxBytesPerSecond = s.openedBytesPerSecond * 1.55;
        s.txBytesPerSecond = 150;
        s.residentBytes = 92'000'000;
        out.push_back(s);
    }
    return out;
}

} // namespace skyseal::ui
