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

std::string_view kindName(VehicleSignatures::Kind kind)
{
    using Kind = VehicleSignatures::Kind;
    switch (kind) {
    case Kind::Verified: return "verified";
    case Kind::Unsigned: return "unsigned";
    case Kind::Wrong: return "wrong_key";
    case Kind::Old: return "old";
    case Kind::Unsignable: return "mavlink1";
    case Kind::KeyChange: return "key_change";
    case Kind::TooManySenders: return "too_many_senders";
    case Kind::TimeNotStored: break;
    }
    return "time_not_stored";
}

void writeSigning(JsonWriter &json, const SigningCounters &counters)
{
    json.key("signing").beginObject();
    json.field("signed", counters.signedFrames).field("verified", counters.verified);
    json.field("unsigned_accepted", counters.unsignedAccepted).field("unsigned_refused", counters.unsignedRefused);
    json.field("wrong_key", counters.wrong).field("old", counters.old);
    json.field("mavlink1_refused", counters.unsignable).field("key_change_refused", counters.keyChanges);
    json.field("too_many_senders", counters.tooManySenders);
    json.endObject();
}

} // namespace

std::string vehicleSigningEvent(const VehicleSignatures &signatures)
{
    JsonWriter json;
    json.beginObject().field("event", "vehicle_signing").field("state", kindName(signatures.kind));
    if (signatures.problem.empty())
        json.field("frames", signatures.frames);
    else
        json.field("problem", signatures.problem);
    json.endObject();
    return json.text();
}

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
    if (!snapshot.vehicle.remoteAddress.empty())
        json.field("vehicle_address", snapshot.vehicle.remoteAddress);
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
    if (snapshot.freshness) {
        json.key("freshness").beginObject();
        writeFreshness(json, *snapshot.freshness);
        json.endObject();
    }
    if (snapshot.signing)
        writeSigning(json, *snapshot.signing);
    if (!snapshot.storageProblem.empty())
        json.field("storage_problem", snapshot.storageProblem.text());
    writeProcess(json, snapshot.processCpuPercent, snapshot.residentBytes);
    json.endObject();
    return json.text();
}

} // namespace skyseal::engine
