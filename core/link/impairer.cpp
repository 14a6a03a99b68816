#include "core/link/impairer.h"

#include "core/base/json_writer.h"
#include "core/link/steady_now.h"

namespace skyseal::link {

Impairer::Impairer(const LinkUrl &listen, const LinkUrl &to, const impair::Settings &settings, const LinkOptions &options)
    : m_sides{makeSide(listen, LinkId{0}, settings, options), makeSide(to, LinkId{1}, settings, options)}
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Impairer::release);
}

Impairer::Side Impairer::makeSide(const LinkUrl &url, LinkId id, const impair::Settings &settings, const LinkOptions &options)
{
    auto link = makeLink(url, id, *this, options);
    connect(link.get(), &Link::stateChanged, this, [this, made = link.get()] { Q_EMIT linkStateChanged(*made); });
    // Datagrams that leave through link 1 go forward; that direction uses random stream 0.
    return {std::move(link), impair::Impairment(settings, id == LinkId{1} ? 0 : 1), {}, {}};
}

void Impairer::open()
{
    for (Side &side : m_sides)
        side.link->open();
}

void Impairer::close()
{
    m_timer.stop();
    for (Side &side : m_sides)
        side.link->close();
}

Impairer::Totals Impairer::totals(Direction direction) const
{
    const Side &side = m_sides[direction == Direction::Forward ? 1 : 0];
    Totals out = side.totals;
    out.counters = side.outgoing.counters();
    return out;
}

bool Impairer::hasPeer(const Side &side) const
{
    return side.peer != Address{} || side.link->remote() != Address{};
}

void Impairer::linkPeerJoined(Link &link, const Path &path)
{
    if (link.remote() == Address{})
        m_sides[static_cast<std::size_t>(link.id())].peer = path.remote;
}

void Impairer::linkReceived(Link &link, std::span<const ReceivedBlock> blocks)
{
    const auto from = static_cast<std::size_t>(link.id());
    Side &source = m_sides[from];
    Side &target = m_sides[1 - from];
    if (link.remote() == Address{})
        source.peer = blocks.back().path.remote;
    if (!hasPeer(target)) {
        target.totals.unroutable += blocks.size();
        return;
    }
    const Direction direction = from == 0 ? Direction::Forward : Direction::Backward;
    for (const ReceivedBlock &block : blocks) {
        link.noteUse(block.path.remote); // the relay cannot judge the content, so every block counts
        take(block, direction, target);
    }
    release();
}

void Impairer::take(const ReceivedBlock &block, Direction direction, Side &target)
{
    const DatagramContents contents = contentsOf(block.bytes);
    const impair::Verdict verdict = target.outgoing.push(block.time, block.bytes);
    if (verdict.dropped()) {
        target.totals.droppedRecords += contents.sealedUnits();
        target.totals.droppedFrames += contents.clearFrames();
    } else if (verdict.duplicated) {
        target.totals.duplicatedRecords += contents.sealedUnits();
        target.totals.duplicatedFrames += contents.clearFrames();
    }
    if (m_log)
        m_log(direction, block.time, verdict, contents);
}

void Impairer::release()
{
    const TimePoint now = steadyNow();
    TimePoint next = kNever;
    for (Side &side : m_sides) {
        impair::Impairment::Delivery delivery;
        while (side.outgoing.pop(now, delivery)) {
            side.link->send(side.link->remote() == Address{} ? side.peer : Address{}, delivery.bytes);
            if (m_deliveryLog)
                m_deliveryLog(&side == &m_sides[1] ? Direction::Forward : Direction::Backward, now, delivery.sequence);
        }
        side.link->flush();
        next = std::min(next, side.outgoing.nextDeadline());
    }
    if (next == kNever)
        m_timer.stop();
    else
        m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(std::max(next - now, Duration(0))));
}

const char *name(Impairer::Direction direction)
{
    return direction == Impairer::Direction::Forward ? "forward" : "backward";
}

static void writeTotals(JsonWriter &json, const Impairer::Totals &totals)
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
        .field("dropped_records", totals.droppedRecords)
        .field("dropped_frames", totals.droppedFrames)
        .field("duplicated_records", totals.duplicatedRecords)
        .field("duplicated_frames", totals.duplicatedFrames)
        .endObject();
}

std::string statsJson(const char *event, const Impairer &impairer, Duration sinceStart)
{
    JsonWriter json;
    json.beginObject().field("event", event).field("t", seconds(sinceStart));
    for (const auto direction : {Impairer::Direction::Forward, Impairer::Direction::Backward}) {
        json.key(name(direction));
        writeTotals(json, impairer.totals(direction));
    }
    json.endObject();
    return json.text();
}

static JsonWriter begin(const char *event, Impairer::Direction direction, Duration sinceStart, std::uint64_t sequence)
{
    JsonWriter json;
    json.beginObject().field("event", event).field("t", seconds(sinceStart));
    json.field("direction", name(direction)).field("sequence", sequence);
    return json;
}

std::string dropJson(Impairer::Direction direction, Duration sinceStart, const impair::Verdict &verdict)
{
    JsonWriter json = begin("drop", direction, sinceStart, verdict.sequence);
    json.field("bytes", static_cast<std::uint64_t>(verdict.bytes))
        .field("reason", verdict.fate == impair::Verdict::Fate::Lost ? "loss" : "queue")
        .endObject();
    return json.text();
}

std::string arrivalJson(Impairer::Direction direction, Duration sinceStart, const impair::Verdict &verdict,
                        const DatagramContents &contents)
{
    using Fate = impair::Verdict::Fate;
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

std::string deliveryJson(Impairer::Direction direction, Duration sinceStart, std::uint64_t sequence)
{
    JsonWriter json = begin("out", direction, sinceStart, sequence);
    json.endObject();
    return json.text();
}

} // namespace skyseal::link
