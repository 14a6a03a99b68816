#include "core/engine/headless/event_json.h"

#include "core/engine/station/snapshot.h"
#include "core/vehicle/state_fields.h"

namespace skyseal::engine {

namespace {

std::uint32_t number(std::uint8_t value)
{
    return value;
}

} // namespace

std::string vehicleEvent(const VehicleFound &found)
{
    JsonWriter json = beginEvent("vehicle");
    json.field("sysid", number(found.systemId)).field("type", number(found.type)).field("autopilot", number(found.autopilot));
    json.field("sealed", found.sealed);
    return endEvent(json);
}

std::string vehicleLostEvent(std::uint8_t systemId, bool lost)
{
    JsonWriter json = beginEvent(lost ? "vehicle_lost" : "vehicle_back");
    json.field("sysid", number(systemId));
    return endEvent(json);
}

std::string statusTextEvent(const vehicle::TextReceived &text)
{
    JsonWriter json = beginEvent("statustext");
    json.field("sysid", number(text.systemId)).field("severity", number(text.text.severity)).field("text", text.text.text);
    return endEvent(json);
}

std::string unansweringEvent(const AgentUnanswering &event)
{
    JsonWriter json = beginEvent("unanswered");
    json.field("state", event.over ? "over" : "begun").field("peer", event.agent.peerName);
    json.field("address", event.agent.remoteAddress).field("own_fingerprint", event.agent.ownFingerprint);
    return endEvent(json);
}

std::string plaintextEvent(const PlaintextRefused &refused)
{
    JsonWriter json = beginEvent("plaintext");
    json.field("sysid", number(refused.systemId)).field("address", refused.remoteAddress).field("frames", refused.frames);
    if (!refused.mayBe.empty())
        json.field("may_be", refused.mayBe);
    return endEvent(json);
}

std::string systemRefusedEvent(const SystemRefused &refused)
{
    JsonWriter json = beginEvent("system_refused");
    json.field("sysid", number(refused.systemId)).field("peer", refused.peer).field("owner", refused.owner);
    json.field("frames", refused.frames);
    return endEvent(json);
}

std::string commandEvent(const vehicle::StepReport &report)
{
    JsonWriter json = beginEvent("command");
    json.field("sysid", number(report.systemId)).field("step", report.step);
    json.field("result", vehicle::stepResultName(report.result)).field("reason", report.reason);
    return endEvent(json);
}

std::string recordingEvent(const RecordingProblem &problem)
{
    JsonWriter json = beginEvent("recording");
    json.field("file", problem.file).field("problem", problem.problem);
    return endEvent(json);
}

std::string eventsDroppedEvent(const EventsDropped &dropped)
{
    JsonWriter json = beginEvent("events_dropped");
    json.field("events", dropped.events);
    return endEvent(json);
}

std::string statsEvent(std::string_view event, const Snapshot &snapshot, double time)
{
    JsonWriter json = beginEvent(event);
    json.field("t", time);
    writeMavlink(json, snapshot.mavlink);
    writeChannel(json, snapshot.channel);
    writeProcess(json, snapshot.processCpuPercent, snapshot.residentBytes);
    json.field("events_dropped", snapshot.eventsDropped);
    if (!snapshot.storageProblem.empty())
        json.field("storage_problem", snapshot.storageProblem);
    json.key("vehicles").beginArray();
    for (const VehicleSnapshot &vehicle : snapshot.vehicles) {
        json.beginObject();
        vehicle::writeStateFields(json, vehicle.state);
        json.endObject();
    }
    json.endArray();
    return endEvent(json);
}

} // namespace skyseal::engine
