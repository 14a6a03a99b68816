#include "core/vehicle/vehicle.h"

#include "core/vehicle/vehicle_parts.h"

#include <algorithm>

namespace skyseal::vehicle {

Vehicle::Vehicle(const VehicleConfig &config, std::uint8_t systemId, std::uint8_t component)
    : m_parts(std::make_unique<Parts>(config, Addressing{config.ownSystemId, config.ownComponentId, systemId, component}))
{}

Vehicle::~Vehicle() = default;
Vehicle::Vehicle(Vehicle &&) noexcept = default;
Vehicle &Vehicle::operator=(Vehicle &&) noexcept = default;

std::uint8_t Vehicle::systemId() const
{
    return m_parts->addressing.system;
}

VehicleState Vehicle::state(TimePoint now) const
{
    VehicleState out = m_parts->state;
    const HeartbeatMonitor &monitor = m_parts->monitor;
    out.texts.assign(m_parts->texts.begin(), m_parts->texts.end());
    out.heartbeatAge = seconds(monitor.heartbeatAge(now));
    out.messageAge = seconds(monitor.messageAge(now));
    out.lost = monitor.isLost(now);
    out.flightTime = m_parts->flightTimer.flightTime(now);
    return out;
}

const VehicleState &Vehicle::current() const
{
    return m_parts->state;
}

bool Vehicle::isLost(TimePoint now) const
{
    return m_parts->monitor.isLost(now);
}

void Vehicle::handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame)
{
    m_parts->handleFrame(now, wall, frame);
}

void Vehicle::handleDeadline(TimePoint now)
{
    Parts &parts = *m_parts;
    parts.joiner.handleDeadline(now);
    parts.takeTexts(now, parts.lastWall);
    parts.streams.handleDeadline(now, parts.outbox);
    parts.timeSync.handleDeadline(now, parts.outbox);
    parts.firmware.handleDeadline(now, parts.outbox);
    parts.commander.handleDeadline(now, parts.state, parts.outbox);
    parts.parameters.handleDeadline(now, parts.outbox);
    parts.mission.handleDeadline(now, parts.outbox);
}

TimePoint Vehicle::nextDeadline() const
{
    const Parts &parts = *m_parts;
    return std::min({parts.joiner.nextDeadline(), parts.streams.nextDeadline(), parts.timeSync.nextDeadline(),
                     parts.firmware.nextDeadline(), parts.commander.nextDeadline(), parts.parameters.nextDeadline(),
                     parts.mission.nextDeadline()});
}

void Vehicle::command(TimePoint now, CommandId id, const VehicleCommand &command)
{
    m_parts->commander.begin(now, id, command, m_parts->state, m_parts->outbox);
}

void Vehicle::requestParameters(TimePoint now)
{
    m_parts->parameters.readAll(now, m_parts->outbox);
}

void Vehicle::writeParameter(TimePoint now, std::string name, double value)
{
    m_parts->parameters.write(now, std::move(name), value, m_parts->outbox);
}

void Vehicle::readMission(TimePoint now)
{
    m_parts->mission.download(now, m_parts->outbox);
}

void Vehicle::writeMission(TimePoint now, std::vector<MissionItem> items)
{
    m_parts->mission.upload(now, std::move(items), m_parts->outbox);
}

void Vehicle::clearMission(TimePoint now)
{
    m_parts->mission.clear(now, m_parts->outbox);
}

void Vehicle::setStreams(TimePoint now, StreamProfile profile, double rate)
{
    m_parts->streams.setProfile(now, profile, rate);
    m_parts->timeSync.setSlow(profile == StreamProfile::LowBandwidth);
}

std::optional<OutMessage> Vehicle::pollOutgoing()
{
    return m_parts->outbox.poll();
}

std::optional<CommandResult> Vehicle::pollResult()
{
    return m_parts->commander.poll();
}

std::optional<StatusText> Vehicle::pollText()
{
    if (m_parts->unread.empty())
        return std::nullopt;
    StatusText text = std::move(m_parts->unread.front());
    m_parts->unread.pop_front();
    return text;
}

std::optional<MissionResult> Vehicle::pollMissionResult()
{
    return m_parts->mission.poll();
}

std::optional<ParameterResult> Vehicle::pollParameterResult()
{
    return m_parts->parameters.poll();
}

std::shared_ptr<const std::vector<Parameter>> Vehicle::parameters() const
{
    return m_parts->parameters.parameters();
}

std::uint32_t Vehicle::parametersExpected() const
{
    return m_parts->parameters.expected();
}

std::shared_ptr<const std::vector<MissionItem>> Vehicle::mission() const
{
    return m_parts->mission.mission();
}

} // namespace skyseal::vehicle
