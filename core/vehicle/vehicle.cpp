#include "core/vehicle/vehicle.h"

#include "core/vehicle/reasons.h"
#include "core/vehicle/request_failure.h"
#include "core/vehicle/vehicle_parts.h"

#include <algorithm>
#include <utility>

namespace skyseal::vehicle {

Vehicle::Vehicle(const VehicleConfig &config, std::uint8_t systemId, std::uint8_t component)
    : m_parts(std::make_unique<Parts>(config, Addressing{config.ownSystemId, config.ownComponentId, systemId, component}))
{}

Vehicle::~Vehicle() = default;
Vehicle::Vehicle(Vehicle &&) noexcept = default;
Vehicle &Vehicle::operator=(Vehicle &&) noexcept = default;

std::uint8_t Vehicle::systemId() const
{
    return m_parts->context.addressing.system;
}

std::uint8_t Vehicle::componentId() const
{
    return m_parts->context.addressing.component;
}

mavlink::AutopilotClaim Vehicle::claim() const
{
    return m_parts->claim;
}

void Vehicle::replaceAutopilot(const VehicleConfig &config, std::uint8_t component)
{
    Addressing ends = m_parts->context.addressing;
    ends.component = component;
    auto parts = std::make_unique<Parts>(config, ends);
    parts->takeOver(*m_parts);
    m_parts = std::move(parts);
}

VehicleState Vehicle::state(TimePoint now) const
{
    VehicleState out = m_parts->context.state;
    const HeartbeatMonitor &monitor = m_parts->monitor;
    out.texts.assign(m_parts->texts.begin(), m_parts->texts.end());
    out.heartbeatAge = seconds(monitor.heartbeatAge(now));
    out.messageAge = seconds(monitor.messageAge(now));
    out.staleAfter = seconds(monitor.lostAfter());
    out.lost = monitor.isLost(now);
    out.flightTime = m_parts->flightTimer.flightTime(now);
    out.takeOffSeen = m_parts->flightTimer.sawTakeOff();
    for (Component &component : out.components)
        component.age = seconds(now - component.heard);
    out.traffic = m_parts->traffic.aircraft(now);
    out.preArmReasons = m_parts->preArm.at(now);
    if (out.preArmOk != true && !out.armed) {
        for (std::string &failure : m_parts->events.failuresFor(out.customMode))
            out.preArmReasons.push_back(std::move(failure));
    }
    for (const MicroProtocol *client : m_parts->context.clients) {
        if (const auto progress = client->progress())
            out.transfers.push_back(*progress);
    }
    return out;
}

const VehicleState &Vehicle::current() const
{
    return m_parts->context.state;
}

bool Vehicle::isLost(TimePoint now) const
{
    return m_parts->monitor.isLost(now);
}

void Vehicle::handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame)
{
    m_parts->handleFrame(now, wall, frame);
}

void Vehicle::handleLateFrame(TimePoint now, const mavlink::Frame &frame)
{
    m_parts->handleLateFrame(now, frame);
}

void Vehicle::handleRadioStatus(const mavlink::RadioStatus &status)
{
    const auto known = [](std::uint8_t value) { return value == 255 ? kUnknown : double(value); };
    RadioState &radio = m_parts->context.state.radio;
    radio.signal = known(status.rssi);
    radio.remoteSignal = known(status.remrssi);
    radio.noise = known(status.noise);
    radio.remoteNoise = known(status.remnoise);
    radio.buffer = status.txbuf <= 100 ? double(status.txbuf) : kUnknown;
}

void Vehicle::handleDeadline(TimePoint now)
{
    m_parts->handleDeadline(now);
}

TimePoint Vehicle::nextDeadline() const
{
    return m_parts->nextDeadline();
}

void Vehicle::perform(TimePoint now, RequestId id, const Request &request)
{
    for (MicroProtocol *client : m_parts->context.clients) {
        if (client->perform(now, id, request)) {
            m_parts->unanswered.note(id, systemId(), request);
            return;
        }
    }
    m_parts->context.events.push_back(failureOf(id, systemId(), request, nothingSent(reasons::kNotSupported)));
}

void Vehicle::setStreams(TimePoint now, StreamProfile profile, double rate)
{
    m_parts->streams.setProfile(now, profile, rate);
    m_parts->modes.setProfile(profile);
    m_parts->timeSync.setSlow(profile == StreamProfile::LowBandwidth);
}

const OutMessage *Vehicle::pollOutgoing()
{
    return m_parts->context.outbox.take();
}

std::optional<Event> Vehicle::pollEvent()
{
    std::deque<Event> &events = m_parts->context.events;
    if (events.empty())
        return std::nullopt;
    Event event = std::move(events.front());
    events.pop_front();
    m_parts->unanswered.handle(event);
    return event;
}

std::shared_ptr<const std::vector<Parameter>> Vehicle::parameters() const
{
    return m_parts->parameters.store().list();
}

std::uint32_t Vehicle::parametersExpected() const
{
    return m_parts->parameters.store().expected();
}

MissionItems Vehicle::mission() const
{
    return m_parts->mission.plan(MissionType::Mission);
}

MissionItems Vehicle::fence() const
{
    return m_parts->mission.plan(MissionType::Fence);
}

MissionItems Vehicle::rally() const
{
    return m_parts->mission.plan(MissionType::Rally);
}

} // namespace skyseal::vehicle
