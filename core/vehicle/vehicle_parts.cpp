#include "core/vehicle/vehicle_parts.h"

#include "core/vehicle/message_io.h"

namespace skyseal::vehicle {

namespace {

MissionItem toItem(const mavlink::MissionItemInt &m)
{
    return {m.seq,      m.command,  m.frame, m.current != 0, m.autocontinue != 0, {m.param1, m.param2, m.param3, m.param4},
            m.x * 1e-7, m.y * 1e-7, m.z};
}

MissionItem toItem(const mavlink::MissionItem &m)
{
    return {m.seq,
            m.command,
            m.frame,
            m.current != 0,
            m.autocontinue != 0,
            {m.param1, m.param2, m.param3, m.param4},
            static_cast<double>(m.x),
            static_cast<double>(m.y),
            m.z};
}

} // namespace

Vehicle::Parts::Parts(const VehicleConfig &config, const Addressing &ends)
    : addressing(ends), streams(ends, config.streams, config.streamRate), timeSync(ends), firmware(ends), commander(ends),
      parameters(ends), mission(ends)
{
    state.systemId = ends.system;
    state.componentId = ends.component;
    timeSync.setInterval(config.timeSyncEvery);
    timeSync.setSlow(config.streams == StreamProfile::LowBandwidth);
}

void Vehicle::Parts::handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame)
{
    lastWall = wall;
    if (frame.messageId() == mavlink::Statustext::kId)
        handleStatusText(now, wall, frame); // other components have something to say, too
    if (frame.componentId() != addressing.component)
        return;
    const bool wasLost = state.lastMessage != TimePoint{} && monitor.isLost(now);
    monitor.handleMessage(now, frame.messageId());
    if (wasLost && !monitor.isLost(now))
        streams.handleReturn(now);
    state.lastMessage = monitor.lastMessage();
    state.lastHeartbeat = monitor.lastHeartbeat();
    streams.handleMessage(now, frame.messageId());
    if (!handleConversation(now, frame))
        takeStatus(now, telemetry.handle(frame, state));
}

bool Vehicle::Parts::handleConversation(TimePoint now, const mavlink::Frame &frame)
{
    switch (frame.messageId()) {
    case mavlink::Heartbeat::kId: handleHeartbeat(now, frame); return true;
    case mavlink::CommandAck::kId: handleAck(now, frame); return true;
    case mavlink::Timesync::kId: {
        const auto m = unpack<mavlink::Timesync>(frame);
        timeSync.handleTimeSync(now, m.tc1, m.ts1, m.target_system, m.target_component, outbox);
        state.latency = timeSync.latency();
        state.trips = timeSync.trips();
        state.tripSeconds = timeSync.tripSeconds();
        return true;
    }
    case mavlink::AutopilotVersion::kId: handleVersion(frame); return true;
    case mavlink::ParamValue::kId: handleParameter(now, frame); return true;
    case mavlink::MissionCount::kId:
    case mavlink::MissionRequest::kId:
    case mavlink::MissionRequestInt::kId:
    case mavlink::MissionItem::kId:
    case mavlink::MissionItemInt::kId:
    case mavlink::MissionAck::kId: handleMission(now, frame); return true;
    default: return false;
    }
}

void Vehicle::Parts::handleHeartbeat(TimePoint now, const mavlink::Frame &frame)
{
    const auto m = unpack<mavlink::Heartbeat>(frame);
    const VehicleKind kind{m.type, m.autopilot};
    const bool first = state.modes.empty() && state.mode.empty();
    if (first || kind != VehicleKind{state.type, state.autopilot}) {
        state.type = m.type;
        state.autopilot = m.autopilot;
        state.modes = modeNames(kind);
        state.mode.clear();
        parameters.setBytewise(kind.isPx4());
    }
    if (state.mode.empty() || state.customMode != m.custom_mode || state.baseMode != m.base_mode)
        state.mode = modeName(kind, m.base_mode, m.custom_mode);
    state.baseMode = m.base_mode;
    state.customMode = m.custom_mode;
    state.systemStatus = m.system_status;
    state.armed = (m.base_mode & mavlink::MAV_MODE_FLAG_SAFETY_ARMED) != 0;
    home.update(state);
    flightTimer.update(now, state.armed, state.altitudeRelative);
    streams.handleHeartbeat(now, kind);
    timeSync.start(now);
    firmware.start(now);
    commander.handleHeartbeat(now, state);
}

void Vehicle::Parts::handleStatusText(TimePoint now, WallTime wall, const mavlink::Frame &frame)
{
    const auto m = unpack<mavlink::Statustext>(frame);
    joiner.handleChunk(now, frame.componentId(), m.severity, m.id, m.chunk_seq, mavlink::textOf(m.text));
    takeTexts(now, wall);
}

void Vehicle::Parts::takeTexts(TimePoint now, WallTime wall)
{
    while (auto text = joiner.poll()) {
        StatusText entry{++lastTextNumber, text->severity, std::move(text->text), wall};
        commander.handleText(now, entry.severity, entry.text);
        if (texts.size() == kMostTexts)
            texts.pop_front();
        texts.push_back(entry);
        if (unread.size() == kMostTexts)
            unread.pop_front();
        unread.push_back(std::move(entry));
    }
}

void Vehicle::Parts::handleAck(TimePoint now, const mavlink::Frame &frame)
{
    const auto m = unpack<mavlink::CommandAck>(frame);
    if (!addressing.isForUs(m.target_system, m.target_component))
        return;
    if (m.command == mavlink::MAV_CMD_SET_MESSAGE_INTERVAL)
        streams.handleIntervalResult(m.result);
    commander.handleAck(now, m.command, m.result, state, outbox);
}

void Vehicle::Parts::handleVersion(const mavlink::Frame &frame)
{
    const auto m = unpack<mavlink::AutopilotVersion>(frame);
    firmware.handleVersion(m.flight_sw_version, {state.type, state.autopilot});
    state.firmware = firmware.text();
    state.capabilities = m.capabilities;
    mission.setTakesIntegers((m.capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_INT) != 0);
    parameters.setBytewise((m.capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE) != 0
                           || VehicleKind{state.type, state.autopilot}.isPx4());
}

void Vehicle::Parts::handleParameter(TimePoint now, const mavlink::Frame &frame)
{
    const auto m = unpack<mavlink::ParamValue>(frame);
    parameters.handleValue(now, {mavlink::textOf(m.param_id), m.param_value, m.param_type, m.param_count, m.param_index},
                           outbox);
}

void Vehicle::Parts::handleMission(TimePoint now, const mavlink::Frame &frame)
{
    const auto route = [&](const auto &m, auto handle) {
        if (addressing.isForUs(m.target_system, m.target_component) && m.mission_type == mavlink::MAV_MISSION_TYPE_MISSION)
            handle(m);
    };
    switch (frame.messageId()) {
    case mavlink::MissionCount::kId:
        return route(unpack<mavlink::MissionCount>(frame), [&](const auto &m) { mission.handleCount(now, m.count, outbox); });
    case mavlink::MissionRequest::kId:
        return route(unpack<mavlink::MissionRequest>(frame),
                     [&](const auto &m) { mission.handleRequest(now, m.seq, false, outbox); });
    case mavlink::MissionRequestInt::kId:
        return route(unpack<mavlink::MissionRequestInt>(frame),
                     [&](const auto &m) { mission.handleRequest(now, m.seq, true, outbox); });
    case mavlink::MissionItem::kId:
        return route(unpack<mavlink::MissionItem>(frame), [&](const auto &m) { mission.handleItem(now, toItem(m), outbox); });
    case mavlink::MissionItemInt::kId:
        return route(unpack<mavlink::MissionItemInt>(frame),
                     [&](const auto &m) { mission.handleItem(now, toItem(m), outbox); });
    default: return route(unpack<mavlink::MissionAck>(frame), [&](const auto &m) { mission.handleAck(now, m.type, outbox); });
    }
}

void Vehicle::Parts::takeStatus(TimePoint now, const TelemetryNews &news)
{
    if (news.home)
        home.handleHomePosition(*news.home, state);
    if (news.landed)
        flightTimer.handleLandedState(*news.landed);
    if (news.positionChanged) {
        home.update(state);
        flightTimer.update(now, state.armed, state.altitudeRelative);
    }
    if (news.missionCurrent)
        commander.handleMissionCurrent(*news.missionCurrent);
    if (news.target)
        commander.handlePositionTarget(news.target->latitude, news.target->longitude);
}

} // namespace skyseal::vehicle
