#include "core/engine/headless/agent_json.h"

#include "core/engine/headless/common_json.h"

namespace skyseal::engine {

namespace {

std::string_view reasonName(FramesRefused::Reason reason)
{
    switch (reason) {
    case FramesRefused::Reason::Observer: return "observer";
    case FramesRefused::Reason::System: return "system";
    case FramesRefused::Reason::TooOften: return "too_often";
    case FramesRefused::Reason::Late: break;
    }
    return "late";
}

} // namespace

std::string framesRefusedEvent(const FramesRefused &refused)
{
    JsonWriter json;
    json.beginObject().field("event", "frames_refused");
    json.field("reason", reasonName(refused.reason));
    json.field("peer", refused.peer).field("frames", refused.frames);
    json.field("message_id", refused.messageId).field("message", refused.messageName);
    if (refused.command != 0)
        json.field("command", std::uint32_t(refused.command));
    json.endObject();
    return json.text();
}

std::string groundIdClaimedEvent(const GroundIdClaimed &claim)
{
    JsonWriter json;
    json.beginObject().field("event", "ground_id_claimed").field("system", std::uint32_t(claim.systemId)).endObject();
    return json.text();
}

std::string agentStatsEvent(std::string_view event, const AgentSnapshot &snapshot, double time)
{
    JsonWriter json;
    json.beginObject().field("event", event).field("t", time);
    writeMavlink(json, snapshot.mavlink);
    writeChannel(json, snapshot.channel);
    json.key("forwarded").beginObject();
    json.field("to_ground", snapshot.counters.toGround).field("to_vehicle", snapshot.counters.toVehicle);
    json.field("observer_refused", snapshot.counters.observerRefused);
    json.field("observer_unclear", snapshot.counters.observerUnclear);
    json.field("observer_too_often", snapshot.counters.observerTooOften);
    json.field("spoof_refused", snapshot.counters.spoofRefused);
    json.field("late_refused", snapshot.counters.lateRefused).field("ground_id_refused", snapshot.counters.groundIdRefused);
    json.field("clear_refused", snapshot.counters.clearRefused).field("undelivered", snapshot.counters.undelivered);
    json.endObject();
    if (!snapshot.storageProblem.empty())
        json.field("storage_problem", snapshot.storageProblem);
    writeProcess(json, snapshot.processCpuPercent, snapshot.residentBytes);
    json.endObject();
    return json.text();
}

} // namespace skyseal::engine
