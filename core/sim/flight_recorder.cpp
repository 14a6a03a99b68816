#include "core/sim/flight_recorder.h"

#include "core/sim/log_record.h"
#include "core/sim/wire_units.h"

namespace skyseal::sim {

namespace {

constexpr std::uint64_t kSample = 100'000; // µs of flight time between samples of attitude and position
constexpr std::uint64_t kSlowSample = 1'000'000;
constexpr std::int64_t kGpsEpoch = 315964800; // s of unix time
constexpr std::int64_t kLeapSeconds = 18, kWeek = 7 * 24 * 3600;

// LogEvent of ArduPilot.
constexpr std::uint8_t kArmedEvent = 10, kDisarmedEvent = 11, kLandedEvent = 18, kNotLandedEvent = 28;

enum Type : std::uint8_t { kPosition = 1, kAttitude, kGps, kBattery, kMode, kEvent, kMessage, kParameter };

constexpr LogLayout kLayouts[] = {
    {LogRecord::kFormatType, "FMT", "BBnNZ", "Type,Length,Name,Format,Columns"},
    {kPosition, "POS", "QLLfff", "TimeUS,Lat,Lng,Alt,RelHomeAlt,RelOriginAlt"},
    {kAttitude, "ATT", "QccccCC", "TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw"},
    {kGps, "GPS", "QBBIHBcLLefffB", "TimeUS,I,Status,GMS,GWk,NSats,HDop,Lat,Lng,Alt,Spd,GCrs,VZ,U"},
    {kBattery, "BAT", "QBffffB", "TimeUS,Inst,Volt,Curr,CurrTot,EnrgTot,RemPct"},
    {kMode, "MODE", "QMBB", "TimeUS,Mode,ModeNum,Rsn"},
    {kEvent, "EV", "QB", "TimeUS,Id"},
    {kMessage, "MSG", "QZ", "TimeUS,Message"},
    {kParameter, "PARM", "QNff", "TimeUS,Name,Value,Default"},
};

std::int16_t hundredths(double radiansValue)
{
    return scaled<std::int16_t>(degrees(radiansValue), 100);
}
std::uint16_t heading(double yaw) // hundredths of a degree, [0, 36000)
{
    const double angle = degrees(yaw);
    return scaled<std::uint16_t>(angle < 0 ? angle + 360 : angle, 100);
}

} // namespace

void FlightRecorder::step(const Autopilot &autopilot)
{
    if (autopilot.armed() && !m_armed)
        begin(autopilot);
    if (!m_armed && !autopilot.armed())
        return;
    writeChanges(autopilot);
    if (autopilot.time() % kSample == 0)
        writeSamples(autopilot);
    if (autopilot.flight().physics.gps().takenAt != m_gpsTakenAt)
        writeGps(autopilot);
    if (!autopilot.armed()) {
        event(autopilot, kDisarmedEvent);
        m_logs.end();
    }
    m_armed = autopilot.armed();
}

void FlightRecorder::begin(const Autopilot &autopilot)
{
    m_logs.begin(static_cast<std::uint32_t>(m_wallTime.time_since_epoch() / std::chrono::seconds(1)));
    for (const LogLayout &layout : kLayouts)
        m_logs.append(LogRecord::describe(layout).bytes());
    const Parameters &parameters = autopilot.parameters();
    for (std::size_t i = 0; i < parameters.count(); ++i) {
        LogRecord record(kParameter);
        record.put(autopilot.time()).text(parameters.info(i).name, 16);
        m_logs.append(record.put(parameters.value(i)).put(parameters.info(i).standard).bytes());
    }
    m_logs.append(LogRecord(kMessage).put(autopilot.time()).text(autopilot.flight().type.greeting(), 64).bytes());
    event(autopilot, kArmedEvent);
    m_mode = FlightMode::Stabilize;
    m_landed = true;
    const auto mode = static_cast<std::uint8_t>((m_mode = autopilot.modes().current(), autopilot.modes().row().number));
    m_logs.append(LogRecord(kMode).put(autopilot.time()).put(mode).put(mode).put(std::uint8_t(0)).bytes());
}

void FlightRecorder::event(const Autopilot &autopilot, std::uint8_t id)
{
    m_logs.append(LogRecord(kEvent).put(autopilot.time()).put(id).bytes());
}

void FlightRecorder::writeChanges(const Autopilot &autopilot)
{
    if (autopilot.modes().current() != m_mode) {
        const auto mode = static_cast<std::uint8_t>((m_mode = autopilot.modes().current(), autopilot.modes().row().number));
        m_logs.append(LogRecord(kMode).put(autopilot.time()).put(mode).put(mode).put(std::uint8_t(0)).bytes());
    }
    if (autopilot.landed() != m_landed) {
        m_landed = autopilot.landed();
        event(autopilot, m_landed ? kLandedEvent : kNotLandedEvent);
    }
}

void FlightRecorder::writeSamples(const Autopilot &autopilot)
{
    const Estimate &e = autopilot.estimate();
    const Euler angles = e.attitude.euler(), wanted = autopilot.craft().target();
    m_logs.append(LogRecord(kAttitude)
                      .put(autopilot.time())
                      .put(hundredths(wanted.roll))
                      .put(hundredths(angles.roll))
                      .put(hundredths(wanted.pitch))
                      .put(hundredths(angles.pitch))
                      .put(heading(wanted.yaw))
                      .put(heading(angles.yaw))
                      .bytes());
    const GeoPoint place = autopilot.flight().world.toGeo(e.position);
    m_logs.append(LogRecord(kPosition)
                      .put(autopilot.time())
                      .put(scaled<std::int32_t>(place.latitude, 1e7))
                      .put(scaled<std::int32_t>(place.longitude, 1e7))
                      .put(place.altitude)
                      .put(autopilot.heightAboveHome())
                      .put(e.altitude())
                      .bytes());
    if (autopilot.time() % kSlowSample != 0)
        return;
    const Battery &battery = autopilot.flight().physics.battery();
    m_logs.append(LogRecord(kBattery)
                      .put(autopilot.time())
                      .put(std::uint8_t(0))
                      .put(battery.voltage())
                      .put(battery.current())
                      .put(battery.consumed())
                      .put(battery.energy() / 3600) // Wh
                      .put(scaled<std::uint8_t>(std::floor(battery.percent())))
                      .bytes());
}

void FlightRecorder::writeGps(const Autopilot &autopilot)
{
    const GpsReport &gps = autopilot.flight().physics.gps();
    m_gpsTakenAt = gps.takenAt;
    const std::int64_t milliseconds = m_wallTime.time_since_epoch() / std::chrono::milliseconds(1)
        - (kGpsEpoch - kLeapSeconds) * 1000;
    const std::int64_t sinceEpoch = std::max<std::int64_t>(milliseconds, 0);
    const GeoPoint place = autopilot.flight().world.toGeo(gps.position);
    const double course = std::atan2(gps.velocity.y, gps.velocity.x);
    m_logs.append(LogRecord(kGps)
                      .put(autopilot.time())
                      .put(std::uint8_t(0))
                      .put(std::uint8_t(gps.fixed ? 3 : 1))
                      .put(static_cast<std::uint32_t>(sinceEpoch % (kWeek * 1000)))
                      .put(static_cast<std::uint16_t>(sinceEpoch / (kWeek * 1000)))
                      .put(static_cast<std::uint8_t>(gps.satellites))
                      .put(scaled<std::int16_t>(gps.hdop, 100))
                      .put(gps.fixed ? scaled<std::int32_t>(place.latitude, 1e7) : 0)
                      .put(gps.fixed ? scaled<std::int32_t>(place.longitude, 1e7) : 0)
                      .put(gps.fixed ? scaled<std::int32_t>(place.altitude, 100) : 0)
                      .put(gps.velocity.horizontal())
                      .put(heading(course) / 100.0)
                      .put(gps.velocity.z)
                      .put(std::uint8_t(1))
                      .bytes());
}

} // namespace skyseal::sim
