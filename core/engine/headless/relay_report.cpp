#include "core/engine/headless/relay_report.h"

#include "core/base/json_writer.h"

namespace skyseal::engine {

using Direction = link::Impairer::Direction;

namespace {

const char *name(Direction direction)
{
    return direction == Direction::Forward ? "forward" : "backward";
}

void writeTotals(JsonWriter &json, const link::Impairer::Totals &totals, const RelayLosses &losses)
{
    const impair::Counters &c = totals.counters;
    json.beginObject()
        .field("offered", c.offered)
        .field("offered_bytes", c.offeredBytes)
        .field("dropped", c.dropped())
        .field("lost", c.lost)
        .field("queue_full", c.queueFull)
        .field("duplicated", c.duplicated)
        .field("held_back", c.heldBack)
        .field("corrupted", c.corrupted)
        .field("delivered", c.delivered)
        .field("delivered_bytes", c.deliveredBytes)
        .field("out_of_order", c.outOfOrder)
        .field("waiting", c.waiting)
        .field("unroutable", totals.unroutable)
        .field("dropped_records", losses.droppedRecords)
        .field("dropped_frames", losses.droppedFrames)
        .field("duplicated_records", losses.duplicatedRecords)
        .field("duplicated_frames", losses.duplicatedFrames)
        .endObject();
}

JsonWriter begin(const char *event, Direction direction, Duration sinceStart, std::uint64_t sequence)
{
    JsonWriter json;
    json.beginObject().field("event", event).field("t", seconds(sinceStart));
    json.field("direction", name(direction)).field("sequence", sequence);
    return json;
}

} // namespace

void RelayLosses::add(const impair::Treatment &verdict, const DatagramContents &contents)
{
    if (verdict.dropped()) {
        ++droppedDatagrams;
        droppedRecords += contents.sealedUnits();
        droppedFrames += contents.clearFrames();
    } else if (verdict.duplicated) {
        duplicatedRecords += contents.sealedUnits();
        duplicatedFrames += contents.clearFrames();
    }
}

std::string statsJson(const char *event, const link::Impairer &impairer, const RelayAccount &account, Duration sinceStart)
{
    JsonWriter json;
    json.beginObject().field("event", event).field("t", seconds(sinceStart));
    for (const auto direction : {Direction::Forward, Direction::Backward}) {
        json.key(name(direction));
        writeTotals(json, impairer.totals(direction), account[static_cast<std::size_t>(direction)]);
    }
    json.endObject();
    return json.text();
}

std::string dropJson(Direction direction, Duration sinceStart, const impair::Treatment &verdict, const RelayLosses &soFar)
{
    JsonWriter json = begin("drop", direction, sinceStart, verdict.sequence);
    json.field("bytes", static_cast<std::uint64_t>(verdict.bytes))
        .field("reason", verdict.fate == impair::Treatment::Fate::Lost ? "loss" : "queue");
    json.key("so_far").beginObject().field("datagrams", soFar.droppedDatagrams);
    json.field("records", soFar.droppedRecords).field("frames", soFar.droppedFrames).endObject().endObject();
    return json.text();
}

std::string arrivalJson(Direction direction, Duration sinceStart, const impair::Treatment &verdict,
                        const DatagramContents &contents)
{
    using Fate = impair::Treatment::Fate;
    JsonWriter json = begin("in", direction, sinceStart, verdict.sequence);
    json.field("bytes", static_cast<std::uint64_t>(verdict.bytes));
    json.field("fate", verdict.fate == Fate::Passed ? "passed" : verdict.fate == Fate::Lost ? "lost" : "queue_full");
    json.field("duplicated", verdict.duplicated).field("held_back", verdict.heldBack).field("corrupted", verdict.corrupted);
    json.key("counters").beginArray();
    for (const std::uint32_t counter : contents.counters)
        json.value(counter);
    json.endArray();
    if (contents.connection)
        json.field("connection", std::uint32_t{*contents.connection});
    if (contents.epoch)
        json.field("epoch", std::uint32_t{*contents.epoch});
    json.key("frames").beginArray();
    for (const DatagramContents::Frame &frame : contents.frames) {
        json.beginArray();
        json.value(std::uint64_t{frame.system}).value(std::uint64_t{frame.component}).value(std::uint64_t{frame.sequence});
        json.endArray();
    }
    json.endArray().endObject();
    return json.text();
}

std::string deliveryJson(Direction direction, Duration sinceStart, std::uint64_t sequence)
{
    JsonWriter json = begin("out", direction, sinceStart, sequence);
    json.endObject();
    return json.text();
}

} // namespace skyseal::engine
