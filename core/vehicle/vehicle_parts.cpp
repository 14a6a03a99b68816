#include "core/vehicle/vehicle_parts.h"

#include <algorithm>

namespace skyseal::vehicle {

Vehicle::Parts::Parts(const VehicleConfig &config, const Addressing &ends)
    : context{ends}, streams(context, config.streams, config.streamRate), modes(context, config.streams)
{
    context.state.systemId = ends.system;
    context.state.componentId = ends.component;
    timeSync.setInterval(config.timeSyncEvery);
    timeSync.setSlow(config.streams == StreamProfile::LowBandwidth);
}

void Vehicle::Parts::takeOver(Parts &former)
{
    context.events = std::move(former.context.events);
    for (const Event &event : context.events)
        former.unanswered.handle(event);
    former.unanswered.fail(context.events);
    texts = std::move(former.texts);
    lastTextNumber = former.lastTextNumber;
    lastWall = former.lastWall;
    joiner = std::move(former.joiner);
    traffic = std::move(former.traffic);
    context.state.radio = former.context.state.radio;
    context.state.components = std::move(former.context.state.components);
    std::erase_if(context.state.components,
                  [this](const Component &component) { return component.id == context.addressing.component; });
}

void Vehicle::Parts::handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame)
{
    lastWall = wall;
    if (frame.messageId() == mavlink::Statustext::kId)
        handleStatusText(now, frame); // of any component, a camera's for example
    if (frame.messageId() == mavlink::AdsbVehicle::kId)
        traffic.handle(now, unpack<mavlink::AdsbVehicle>(frame), context.state.position); // the receiver may be a component
    if (frame.componentId() != context.addressing.component) {
        if (frame.messageId() == mavlink::Heartbeat::kId)
            noteComponent(now, frame);
        parameters.handleFrame(now, frame);
        return;
    }
    VehicleState &state = context.state;
    const bool wasLost = state.lastMessage != TimePoint{} && monitor.isLost(now);
    monitor.handleMessage(now, frame.messageId());
    version.handleFrame(now, frame.version());
    state.mavlinkVersion = static_cast<std::uint8_t>(version.version());
    if (wasLost && !monitor.isLost(now))
        streams.restart(now);
    state.lastMessage = monitor.lastMessage();
    state.lastHeartbeat = monitor.lastHeartbeat();
    const bool taken = offerToClients(now, frame);
    const mavlink::Heartbeat before{.type = state.type,
                                    .autopilot = state.autopilot,
                                    .base_mode = state.baseMode,
                                    .custom_mode = state.customMode,
                                    .system_status = state.systemStatus};
    if (const auto heartbeat = mavlink::heartbeatOf(frame, before)) {
        state.highLatency = mavlink::isHighLatency(frame.messageId());
        claim = std::max(claim, mavlink::autopilotClaim(frame.componentId(), *heartbeat));
        handleHeartbeat(now, *heartbeat);
    }
    if (frame.messageId() == mavlink::ParamValue::kId) {
        const auto parameter = unpack<mavlink::ParamValue>(frame);
        if (mavlink::textOf(parameter.param_id) == "Q_ENABLE" && parameter.param_value > 0)
            noteVerticalTakeOff();
    }
    if (frame.messageId() == mavlink::Event::kId)
        events.handle(now, unpack<mavlink::Event>(frame));
    else if (!taken)
        handleTelemetry(now, frame);
}

void Vehicle::Parts::handleLateFrame(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() == mavlink::Statustext::kId)
        handleStatusText(now, frame);
    if (frame.componentId() == context.addressing.component)
        offerToClients(now, frame);
    else
        parameters.handleFrame(now, frame);
}

bool Vehicle::Parts::offerToClients(TimePoint now, const mavlink::Frame &frame)
{
    return std::any_of(context.clients.begin(), context.clients.end(),
                       [&](MicroProtocol *client) { return client->handleFrame(now, frame); });
}

void Vehicle::Parts::handleDeadline(TimePoint now)
{
    joiner.handleDeadline(now);
    events.handleDeadline(now);
    takeTexts(now);
    for (MicroProtocol *client : context.clients)
        client->handleDeadline(now);
}

TimePoint Vehicle::Parts::nextDeadline() const
{
    TimePoint next = std::min(joiner.nextDeadline(), events.nextDeadline());
    for (const MicroProtocol *client : context.clients)
        next = std::min(next, client->nextDeadline());
    return next;
}

void Vehicle::Parts::noteComponent(TimePoint now, const mavlink::Frame &heartbeat)
{
    const auto m = unpack<mavlink::Heartbeat>(heartbeat);
    std::vector<Component> &known = context.state.components;
    auto place = std::ranges::lower_bound(known, heartbeat.componentId(), {}, &Component::id);
    if (place == known.end() || place->id != heartbeat.componentId()) {
        if (known.size() >= kMostComponents)
            return;
        place = known.insert(place, Component{.id = heartbeat.componentId()});
    }
    place->type = m.type;
    place->autopilot = m.autopilot;
    place->heard = now;
}

void Vehicle::Parts::handleHeartbeat(TimePoint now, const mavlink::Heartbeat &m)
{
    VehicleState &state = context.state;
    const VehicleKind kind{m.type, m.autopilot};
    const bool first = state.modes.empty() && state.mode.empty();
    if (first || kind != context.kind()) {
        state.type = m.type;
        state.autopilot = m.autopilot;
        state.ownModes.clear();
        state.verticalTakeOff = false;
        state.modes = modeNames(kind);
        state.mode.clear();
    }
    if (state.mode.empty() || state.customMode != m.custom_mode || state.baseMode != m.base_mode)
        state.mode = modeName(kind, m.base_mode, m.custom_mode, state.ownModes);
    state.baseMode = m.base_mode;
    state.customMode = m.custom_mode;
    state.systemStatus = m.system_status;
    state.armed = (m.base_mode & mavlink::MAV_MODE_FLAG_SAFETY_ARMED) != 0;
    if (state.armed)
        preArm.clear();
    if (isVerticalMode(kind, m.custom_mode))
        noteVerticalTakeOff();
    home.update(state);
    noteFlight(now);
    for (MicroProtocol *client : context.clients)
        client->handleHeartbeat(now);
}

void Vehicle::Parts::handleStatusText(TimePoint now, const mavlink::Frame &frame)
{
    const auto m = unpack<mavlink::Statustext>(frame);
    joiner.handleChunk(now, frame.componentId(), m.severity, m.id, m.chunk_seq, mavlink::textOf(m.text));
    takeTexts(now);
}

void Vehicle::Parts::handleTelemetry(TimePoint now, const mavlink::Frame &frame)
{
    VehicleState &state = context.state;
    const bool checksPassed = state.preArmOk.value_or(false);
    if (frame.messageId() == mavlink::MissionCurrent::kId)
        mission.handleCurrent(now, unpack<mavlink::MissionCurrent>(frame));
    const TelemetryUpdate update = telemetry.handle(now, frame, state);
    if (update.verticalTakeOff)
        noteVerticalTakeOff();
    if (!checksPassed && state.preArmOk.value_or(false))
        preArm.clear(); // reasons that it says later, at an attempt, count
    if (update.home)
        home.handleHomePosition(*update.home, state);
    if (update.restarted)
        flightTimer.restart(); // the flight before ended unseen
    if (update.landed)
        flightTimer.handleLandedState(*update.landed);
    if (update.positionChanged) {
        home.update(state);
        noteFlight(now);
    }
    state.inAir = flightTimer.isFlying();
}

void Vehicle::Parts::noteFlight(TimePoint now)
{
    flightTimer.update(now, context.state.armed, context.state.altitudeRelative);
    context.state.inAir = flightTimer.isFlying();
}

void Vehicle::Parts::noteVerticalTakeOff()
{
    VehicleState &state = context.state;
    if (state.verticalTakeOff || !context.kind().isPlane())
        return;
    state.verticalTakeOff = true;
    state.modes = modeNames(context.kind(), true, state.ownModes);
}

void Vehicle::Parts::takeTexts(TimePoint now)
{
    while (auto text = joiner.poll()) {
        if (text->text.ends_with('\t')) { // PX4 says the same by an event
            text->text.pop_back();
            if (text->component == context.addressing.component)
                events.handleText(now, text->severity);
        }
        addText(now, text->component, text->severity, std::move(text->text));
    }
    while (auto text = events.poll())
        addText(now, context.addressing.component, text->severity, std::move(text->text));
}

void Vehicle::Parts::addText(TimePoint now, std::uint8_t component, std::uint8_t severity, std::string text)
{
    const StatusText entry{++lastTextNumber, severity, std::move(text), lastWall};
    if (component == context.addressing.component && !context.state.armed)
        preArm.handleText(now, entry.text);
    for (MicroProtocol *client : context.clients)
        client->handleText(entry);
    if (texts.size() == kMaxTexts)
        texts.pop_front();
    texts.push_back(entry);
    if (context.events.size() < kMaxTexts) // results are never dropped, texts are if the events are not drained
        context.events.push_back(TextReceived{context.addressing.system, entry});
}

} // namespace skyseal::vehicle
