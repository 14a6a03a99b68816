#include "core/engine/headless/common_json.h"

#include "core/engine/headless/event_names.h"

namespace skyseal::engine {

JsonWriter beginEvent(std::string_view event)
{
    JsonWriter json;
    json.beginObject().field("event", event);
    return json;
}

std::string endEvent(JsonWriter &json)
{
    json.endObject();
    return json.text();
}

namespace {

void writeReceived(JsonWriter &json, const channel::ReceiveCounters &counters)
{
    json.field("good", counters.good)
        .field("late", counters.late)
        .field("lost", counters.lost)
        .field("replayed", counters.replayed)
        .field("forged", counters.forged)
        .field("malformed", counters.malformed)
        .field("plaintext_dropped", counters.plaintextDropped)
        .field("opened_bytes", counters.openedBytes)
        .field("stale", counters.stale);
}

} // namespace

std::string linkEvent(const LinkSnapshot &link, std::string_view side)
{
    JsonWriter json = beginEvent("link");
    if (!side.empty())
        json.field("side", side);
    json.field("url", link.url).field("state", keyword(link.phase)).field("address", link.localAddress);
    if (link.listenOnly)
        json.field("framing", "mavsec2019").field("insecure", true);
    if (!link.problem.empty())
        json.field("problem", link.problem.text());
    return endEvent(json);
}

std::string counterStorageEvent(const CounterStorage &storage)
{
    JsonWriter json = beginEvent("counter_storage");
    json.field("works", storage.problem.empty());
    if (!storage.problem.empty())
        json.field("problem", storage.problem.text());
    return endEvent(json);
}

void writeMavlink(JsonWriter &json, const MavlinkTotals &totals)
{
    json.key("mavlink").beginObject();
    json.field("frames", totals.frames).field("lost", totals.lost).field("late", totals.late);
    json.field("duplicate", totals.duplicate).field("bad_crc", totals.badCrc);
    json.field("senders_evicted", totals.sendersEvicted);
    json.endObject();
}

void writeChannel(JsonWriter &json, const ChannelTotals &totals)
{
    json.key("channel").beginObject();
    json.field("up", totals.up).field("suite", crypto::suiteInfo(totals.suite).name).field("epoch", totals.epoch);
    json.field("framing", keyword(totals.framing));
    json.key("rx").beginObject();
    writeReceived(json, totals.rx);
    json.endObject();
    json.key("unmatched").beginObject(); // contained in rx: repeated handshakes, garbage
    json.field("replayed", totals.unmatched.replayed).field("forged", totals.unmatched.forged);
    json.field("malformed", totals.unmatched.malformed).endObject();
    // The sent records, and their fate as counted by the other end.
    json.key("tx").beginObject();
    json.field("records", totals.tx.records).field("sealed_bytes", totals.tx.sealedBytes);
    writeReceived(json, totals.peerRx);
    json.endObject();
    if (totals.peerFrames) {
        json.key("tx_mavlink").beginObject();
        json.field("frames", totals.peerFrames->taken).field("lost", totals.peerFrames->lost).endObject();
    }
    json.field("open_ns_p50", totals.cost.openNsP50).field("open_ns_p99", totals.cost.openNsP99);
    json.field("seal_ns_p50", totals.cost.sealNsP50).field("seal_ns_p99", totals.cost.sealNsP99);
    json.field("cpu_percent", totals.cost.cpuPercent);
    json.endObject();
}

void writeFreshness(JsonWriter &json, const channel::FreshnessReport &report)
{
    if (report.isAgeKnown())
        json.field("age_ms", double(report.ageMicroseconds) / 1e3);
    else
        json.key("age_ms").null();
    json.field("overtaken_limit_ms", report.overtakenMilliseconds).field("age_limit_ms", report.limitMilliseconds);
}

void writeProcess(JsonWriter &json, double cpuPercent, std::uint64_t residentBytes)
{
    json.key("process").beginObject();
    json.field("cpu_percent", cpuPercent).field("rss_bytes", residentBytes);
    json.endObject();
}

} // namespace skyseal::engine
