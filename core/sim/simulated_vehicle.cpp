#include "core/sim/simulated_vehicle.h"

#include "core/mavlink/messages.h"
#include "core/sim/command_server.h"
#include "core/sim/control_server.h"
#include "core/sim/flight_recorder.h"
#include "core/sim/frame_router.h"
#include "core/sim/ftp_server.h"
#include "core/sim/gcs_watch.h"
#include "core/sim/log_server.h"
#include "core/sim/message_signing.h"
#include "core/sim/mission_server.h"
#include "core/sim/parameter_server.h"

#include <array>

namespace skyseal::sim {

namespace {
constexpr Duration kLongestGap = std::chrono::seconds(1);
constexpr Duration kMostCatchUp = std::chrono::minutes(1); // of flight in one call, after the machine slept for hours
constexpr Duration kLook = std::chrono::milliseconds(50);  // texts, failsafes and mission progress come out of flying
} // namespace

/// Everything that a reboot makes anew.
struct SimulatedVehicle::Parts
{
    Parts(const SimulatedVehicleConfig &config, std::uint8_t systemId, TimePoint now)
        : autopilot(config.autopilot), outbox(systemId), telemetry(autopilot, outbox, config.autopilot.seed),
          streams(now, config.autopilot.type.firmware), commands(autopilot, streams, telemetry, outbox),
          control(autopilot, outbox), missions(autopilot, parameters, outbox),
          parameters(autopilot.parameters(), outbox, autopilot.texts()), recorder(flightLogs),
          logs(flightLogs, autopilot, outbox), files(card, flightLogs, autopilot), ftp(files, outbox), last(now), look(now)
    {}

    void fly(Duration span);
    void watchStation(TimePoint now);
    void speak(TimePoint now);
    void notifyStatus();

    Autopilot autopilot;
    FrameQueue outbox;
    TelemetrySender telemetry;
    StreamScheduler streams;
    CommandServer commands;
    ControlServer control;
    MissionServer missions;
    ParameterServer parameters;
    FlightLogs flightLogs;
    FlightRecorder recorder;
    LogServer logs;
    FileStore card;
    VehicleFiles files;
    FtpServer ftp;
    GcsWatch station;
    TimePoint last;
    TimePoint look;  ///< when to look next for what flying brought up
    Duration owed{}; ///< of flight, not stepped yet
    bool homeSent = false;
    std::uint16_t breachesReported = 0;
    bool actedOnSilence = false; ///< of the station, in this flight
};

SimulatedVehicle::SimulatedVehicle(const SimulatedVehicleConfig &config, TimePoint now)
    : m_config(config), m_boot(now), m_signing(std::make_unique<MessageSigning>()),
      m_parts(std::make_unique<Parts>(config, config.systemId, now))
{
    Autopilot &autopilot = m_parts->autopilot;
    autopilot.parameters().set(autopilot.parameters().systemIdName(), config.systemId);
    autopilot.parameters().set("SIM_SPEEDUP", static_cast<float>(config.rate));
    autopilot.texts().say(Severity::Info, config.autopilot.type.greeting());
    m_parts->streams.applyParameters(now, autopilot.parameters());
}

SimulatedVehicle::~SimulatedVehicle() = default;
SimulatedVehicle::SimulatedVehicle(SimulatedVehicle &&) noexcept = default;
SimulatedVehicle &SimulatedVehicle::operator=(SimulatedVehicle &&) noexcept = default;

void SimulatedVehicle::advance(TimePoint now)
{
    Parts &parts = *m_parts;
    if (now - parts.last > kLongestGap) {
        parts.fly(now - parts.last);
        parts.last = now;
        parts.look = std::max(parts.look, now);
        parts.streams.skipTo(now);
    }
    // From event to event, so that the output does not depend on how often this is called.
    for (TimePoint next = nextDeadline(); next <= now; next = nextDeadline()) {
        parts.fly(std::max(next, parts.last) - parts.last);
        parts.last = std::max(next, parts.last);
        const WallTime wall = m_config.bootTime + std::chrono::duration_cast<WallTime::duration>(next - m_boot);
        parts.telemetry.setWallTime(wall);
        parts.recorder.setWallTime(wall);
        if (m_config.bootTime != WallTime())
            m_signing->noteTime(wall);
        parts.speak(next);
    }
    parts.fly(now - parts.last);
    parts.last = now;
    m_signing->saveIfDue(now);
    if (parts.commands.takeReboot())
        reboot(now);
}

void SimulatedVehicle::Parts::fly(Duration span)
{
    constexpr Duration step = std::chrono::microseconds(Autopilot::kStep);
    const auto rate = static_cast<double>(autopilot.parameters().value("SIM_SPEEDUP"));
    // Whole nanoseconds: the steps of a flight must not depend on how it was cut into spans.
    owed += std::min(rate == 1 ? span : std::chrono::duration_cast<Duration>(span * rate), kMostCatchUp);
    for (; owed >= step; owed -= step) {
        autopilot.step();
        recorder.step(autopilot);
    }
}

void SimulatedVehicle::Parts::watchStation(TimePoint now)
{
    const Parameters &values = autopilot.parameters();
    const FailsafeSettings &settings = autopilot.flight().settings.failsafes;
    const auto timeout = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(settings.stationTimeout));
    const auto override = std::chrono::duration_cast<Duration>(std::chrono::duration<float>(values.value("RC_OVERRIDE_TIME")));
    autopilot.flight().pilot.expire(now, override);
    if (station.update(now, timeout) == GcsWatch::Event::Back)
        autopilot.failsafes().clear("GCS");
    if (!autopilot.armed() || !station.lost())
        actedOnSilence = false;
    else if (settings.station && !std::exchange(actedOnSilence, true))
        autopilot.failsafes().trigger("GCS", *settings.station);
}

void SimulatedVehicle::Parts::speak(TimePoint now)
{
    if (now >= look) {
        look = now + kLook;
        watchStation(now);
        notifyStatus();
    }
    streams.applyParameters(now, autopilot.parameters());
    while (const auto message = streams.pollDue(now))
        telemetry.send(*message);
    parameters.handleDeadline(now);
    missions.handleDeadline(now);
    logs.handleDeadline(now);
    ftp.handleDeadline(now);
}

void SimulatedVehicle::Parts::notifyStatus()
{
    missions.reportProgress();
    if (const auto breaches = autopilot.flight().fence.breachCount(); breaches != std::exchange(breachesReported, breaches))
        telemetry.send(mavlink::FenceStatus::kId);
    if (!homeSent)
        homeSent = telemetry.send(mavlink::HomePosition::kId);
    while (const auto text = autopilot.texts().take())
        telemetry.sendText(*text);
}

/// Of each station, every second or more often.
static constexpr std::array<std::uint32_t, 8> kUsual{
    mavlink::Attitude::kId,   mavlink::RawImu::kId,    mavlink::VfrHud::kId,         mavlink::GlobalPositionInt::kId,
    mavlink::RcChannels::kId, mavlink::GpsRawInt::kId, mavlink::ServoOutputRaw::kId, mavlink::SysStatus::kId};

void SimulatedVehicle::sendTelemetry(TimePoint now, std::uint64_t first, std::size_t messages)
{
    advance(now);
    for (std::size_t i = 0; i < messages; ++i)
        m_parts->telemetry.send(kUsual[(first + i) % kUsual.size()]);
}

void SimulatedVehicle::sendBurst(TimePoint now, std::size_t messages, std::int64_t ticket)
{
    // Two kinds a burst and all in four, each together: a link may send those of one size as one piece.
    constexpr std::size_t kKinds = 2;
    advance(now);
    for (std::size_t i = 0; i < messages; ++i) {
        const std::size_t kind = i * kKinds / messages + kKinds * static_cast<std::size_t>(ticket);
        m_parts->telemetry.send(kUsual[kind % kUsual.size()]);
    }
    mavlink::Timesync request;
    request.ts1 = ticket;
    m_parts->outbox.send(request);
}

void SimulatedVehicle::sendHeartbeat()
{
    m_parts->telemetry.send(mavlink::Heartbeat::kId);
}

TimePoint SimulatedVehicle::nextDeadline() const
{
    return std::min({m_parts->streams.nextDeadline(), m_parts->parameters.nextDeadline(), m_parts->missions.nextDeadline(),
                     m_parts->logs.nextDeadline(), m_parts->ftp.nextDeadline(), m_parts->look});
}

void SimulatedVehicle::handleFrame(TimePoint now, const mavlink::Frame &frame, LinkTrust trust)
{
    advance(now);
    if (!m_signing->accepts(frame, trust))
        return;
    if (frame.messageId() == mavlink::SetupSigning::kId)
        return setUpSigning(now, frame);
    Parts &parts = *m_parts;
    const FrameRouter router{parts.autopilot,  parts.outbox, parts.streams, parts.commands, parts.control, parts.missions,
                             parts.parameters, parts.logs,   parts.ftp,     parts.station,  m_boot,        systemId()};
    router.route(now, frame);
    parts.notifyStatus();
}

void SimulatedVehicle::setUpSigning(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.targetSystem() != 0 && frame.targetSystem() != systemId())
        return;
    if (m_parts->autopilot.armed()) {
        m_parts->autopilot.texts().say(Severity::Error, "Won't setup signing when armed");
        m_parts->notifyStatus();
        return;
    }
    m_signing->setUp(now, mavlink::SetupSigning::decode(frame.payload()));
    m_parts->outbox.setSigner(m_signing->signer());
}

void SimulatedVehicle::reboot(TimePoint now)
{
    const Parameters kept = m_parts->autopilot.parameters();
    MissionServer::StoredLists lists = m_parts->missions.stored();
    FlightLogs flightLogs = std::move(m_parts->flightLogs);
    FileStore card = std::move(m_parts->card);
    FrameQueue unsent = std::move(m_parts->outbox);
    const auto id = static_cast<std::uint8_t>(kept.integer(kept.systemIdName()));
    m_parts = std::make_unique<Parts>(m_config, id, now);
    m_parts->autopilot.parameters() = kept;
    m_parts->missions.restore(std::move(lists));
    m_parts->outbox.takeOver(unsent);
    m_parts->flightLogs = std::move(flightLogs);
    m_parts->card = std::move(card);
    m_config.systemId = id;
    m_signing->restart();
    m_parts->outbox.setSigner(m_signing->signer());
    m_parts->streams.applyParameters(now, kept);
}

ByteView SimulatedVehicle::pollFrame()
{
    return m_parts->outbox.poll();
}
std::uint64_t SimulatedVehicle::dropped() const
{
    return m_parts->outbox.dropped();
}
std::uint8_t SimulatedVehicle::systemId() const
{
    return m_config.systemId;
}
const Autopilot &SimulatedVehicle::autopilot() const
{
    return m_parts->autopilot;
}
Autopilot &SimulatedVehicle::autopilot()
{
    return m_parts->autopilot;
}

} // namespace skyseal::sim
