#include "core/engine/headless/event_json.h"

#include "core/base/overloaded.h"
#include "core/engine/headless/channel_event_json.h"
#include "core/engine/station/snapshot.h"
#include "core/vehicle/state_fields.h"

#include <algorithm>

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
    if (!found.recorded)
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

namespace {

void writeSystems(JsonWriter &json, std::string_view name, const std::vector<std::uint8_t> &systems)
{
    json.key(name).beginArray();
    for (const std::uint8_t systemId : systems)
        json.value(number(systemId));
    json.endArray();
}

void writeOtherSystems(JsonWriter &json, const OtherSystemsHeard &heard)
{
    json.field("peer", heard.peer);
    writeSystems(json, "systems", heard.systems);
    writeSystems(json, "vehicles", heard.vehicles);
    json.field("frames", heard.frames);
}

} // namespace

std::string otherSystemsEvent(const OtherSystemsHeard &heard)
{
    JsonWriter json = beginEvent("other_systems");
    writeOtherSystems(json, heard);
    return endEvent(json);
}

std::string ownIdEvent(const OwnIdClaimed &claim)
{
    JsonWriter json = beginEvent("system_id_conflict");
    json.field("sysid", number(claim.systemId)).field("component", number(claim.componentId));
    json.field("address", claim.remoteAddress);
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
    json.field("file", problem.file).field("problem", problem.problem.text());
    return endEvent(json);
}

std::string eventsDroppedEvent(const EventsDropped &dropped)
{
    JsonWriter json = beginEvent("events_dropped");
    json.field("events", dropped.events);
    return endEvent(json);
}

std::string servedLinkEvent(const ServedLinkChanged &served)
{
    return linkEvent(served.link, "clients");
}

std::string clientEvent(const ClientConnected &client)
{
    JsonWriter json = beginEvent("client");
    json.field("state", "connected").field("name", client.name).field("address", client.address);
    json.field("write", client.write);
    return endEvent(json);
}

std::string clientEvent(const ClientGone &client)
{
    JsonWriter json = beginEvent("client");
    json.field("state", "gone").field("name", client.name).field("address", client.address);
    return endEvent(json);
}

std::string clientDeniedEvent(const ClientDenied &denied)
{
    JsonWriter json = beginEvent("client_denied");
    json.field("name", denied.name).field("address", denied.address).field("message", denied.message);
    json.field("frames", denied.frames);
    return endEvent(json);
}

std::string clientsUnreportedEvent(const ClientsUnreported &unreported)
{
    JsonWriter json = beginEvent("clients_unreported");
    json.field("clients", unreported.clients).field("frames", unreported.frames);
    return endEvent(json);
}

std::string brokerEvent(const std::string &url, const mqtt::PublisherStatus &broker)
{
    JsonWriter json = beginEvent("mqtt");
    json.field("state", broker.connected ? "connected" : "waiting").field("url", url).field("problem", broker.problem);
    return endEvent(json);
}

std::string eventJson(const Event &event, const PeerNames &names)
{
    return std::visit(Overloaded{
                          [](const LinkChanged &e) { return linkEvent(e.link); },
                          [](const VehicleFound &e) { return vehicleEvent(e); },
                          [](const VehicleLost &e) { return vehicleLostEvent(e.systemId, true); },
                          [](const VehicleBack &e) { return vehicleLostEvent(e.systemId, false); },
                          [](const vehicle::TextReceived &e) { return statusTextEvent(e); },
                          [](const PlaintextRefused &e) { return plaintextEvent(e); },
                          [](const SystemRefused &e) { return systemRefusedEvent(e); },
                          [](const OtherSystemsHeard &e) { return otherSystemsEvent(e); },
                          [](const OwnIdClaimed &e) { return ownIdEvent(e); },
                          [](const AgentUnanswering &e) { return unansweringEvent(e); },
                          [](const RecordingProblem &e) { return recordingEvent(e); },
                          [](const EventsDropped &e) { return eventsDroppedEvent(e); },
                          [](const CounterStorage &e) { return counterStorageEvent(e); },
                          [](const ServedLinkChanged &e) { return servedLinkEvent(e); },
                          [](const ClientConnected &e) { return clientEvent(e); },
                          [](const ClientGone &e) { return clientEvent(e); },
                          [](const ClientDenied &e) { return clientDeniedEvent(e); },
                          [](const ClientsUnreported &e) { return clientsUnreportedEvent(e); },
                          [](const vehicle::MissionResult &) { return std::string(); },
                          [](const vehicle::ParameterResult &) { return std::string(); },
                          [](const vehicle::FileResult &) { return std::string(); },
                          [](const vehicle::LogResult &) { return std::string(); },
                          [](const vehicle::CommandResult &) { return std::string(); }, // the script reports its steps
                          // Events of the channel; no others convert to channel::Event.
                          [&names](const auto &e) { return channelEvent(e, names); },
                      },
                      event);
}

namespace {

void writeClients(JsonWriter &json, const std::vector<ClientSnapshot> &clients)
{
    json.key("clients").beginArray();
    for (const ClientSnapshot &client : clients) {
        json.beginObject();
        json.field("name", client.name).field("address", client.address).field("write", client.write);
        json.field("forwarded", client.counters.forwarded).field("denied", client.counters.denied);
        json.field("too_often", client.counters.tooOften).field("not_its_system", client.counters.notItsSystem);
        json.endObject();
    }
    json.endArray();
}

void writeCount(JsonWriter &json, std::string_view kind, const mqtt::PublishCount &count)
{
    json.key(kind).beginObject().field("sent", count.sent).field("dropped", count.dropped).endObject();
}

void writeBroker(JsonWriter &json, const mqtt::PublisherStatus &broker)
{
    json.key("mqtt").beginObject().field("connected", broker.connected).field("problem", broker.problem);
    json.field("connections", broker.connections);
    writeCount(json, "state", broker.state);
    writeCount(json, "event", broker.event);
    writeCount(json, "raw", broker.raw);
    json.endObject();
}

void writeVehicle(JsonWriter &json, const vehicle::VehicleState &state)
{
    vehicle::writeStateFields(json, state);
    json.field("component", number(state.componentId)).key("components").beginArray();
    for (const vehicle::Component &component : state.components) {
        json.beginObject().field("component", number(component.id)).field("type", number(component.type));
        json.field("autopilot", number(component.autopilot)).field("heartbeat_age", component.age).endObject();
    }
    json.endArray();
}

void writeStatistics(JsonWriter &json, const Snapshot &snapshot, double time)
{
    json.field("t", time);
    writeMavlink(json, snapshot.mavlink);
    writeChannel(json, snapshot.channel);
    writeProcess(json, snapshot.processCpuPercent, snapshot.residentBytes);
    json.field("events_dropped", snapshot.eventsDropped);
    if (!snapshot.storageProblem.empty())
        json.field("storage_problem", snapshot.storageProblem.text());
    if (!snapshot.served.empty())
        writeClients(json, snapshot.clients);
    if (snapshot.broker)
        writeBroker(json, *snapshot.broker);
    if (!snapshot.otherSystems.empty()) {
        json.key("other_systems").beginArray();
        for (const OtherSystemsHeard &heard : snapshot.otherSystems) {
            json.beginObject();
            writeOtherSystems(json, heard);
            json.endObject();
        }
        json.endArray();
    }
    json.key("vehicles").beginArray();
    for (const VehicleSnapshot &vehicle : snapshot.vehicles) {
        json.beginObject();
        writeVehicle(json, vehicle.state);
        json.endObject();
    }
    json.endArray();
}

} // namespace

std::string statsEvent(std::string_view event, const Snapshot &snapshot, double time)
{
    JsonWriter json = beginEvent(event);
    writeStatistics(json, snapshot, time);
    return endEvent(json);
}

std::string vehicleStateEvent(const Snapshot &snapshot, const VehicleSnapshot &vehicle, WallTime now)
{
    JsonWriter json = beginEvent("state");
    json.field("time", std::chrono::duration<double>(now.time_since_epoch()).count());
    const auto session = std::ranges::find_if(
        snapshot.sessions, [&vehicle](const SessionSnapshot &one) { return vehicle.session == one.info.session; });
    if (!isRecorded(snapshot, vehicle))
        json.field("sealed", session != snapshot.sessions.end());
    if (session != snapshot.sessions.end()) {
        json.field("peer", session->info.peerName).field("suite", crypto::suiteInfo(session->info.suite).name);
        json.field("under_attack", isAttacked(*session));
    }
    json.field("loss_percent", vehicle.lossPercent);
    writeVehicle(json, vehicle.state);
    return endEvent(json);
}

std::string statusEvent(const Snapshot &snapshot)
{
    JsonWriter json = beginEvent("status");
    writeStatistics(json, snapshot, snapshot.time);
    json.key("sessions").beginArray();
    for (const SessionSnapshot &session : snapshot.sessions) {
        json.beginObject();
        json.field("peer", session.info.peerName).field("suite", crypto::suiteInfo(session.info.suite).name);
        json.field("epoch", static_cast<std::uint32_t>(session.info.epoch));
        json.endObject();
    }
    json.endArray();
    return endEvent(json);
}

} // namespace skyseal::engine
