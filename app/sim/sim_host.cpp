#include "app/sim/sim_host.h"

#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/link/steady_now.h"

namespace skyseal::app {

namespace {

// Every wake-up costs about 15 µs, so telemetry that falls due in between waits for the next one.
constexpr Duration kShortestSleep = std::chrono::milliseconds(4);
constexpr Duration kPaceEvery = std::chrono::milliseconds(100); ///< between two reports of the paced load
constexpr std::uint64_t kAtOnce = 100;                          ///< messages that fit a vehicle's outbox
constexpr double kSpacing = 12;                                 // m between vehicles on the ground

const char *verb(const link::Link &link)
{
    return link.state() == link::LinkState::Listening ? "listening on " : "connected to ";
}

} // namespace

SimHost::SimHost(const SimSettings &settings, SentFraming framing) : m_settings(settings), m_framing(std::move(framing))
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &SimHost::live);
}

void SimHost::start()
{
    makeVehicles(steadyNow());
    link::LinkOptions options;
    options.segmentedUdp = m_settings.saturate; // the generator must not be the bottleneck
    for (const link::LinkUrl &url : m_settings.links) {
        const LinkId id{static_cast<std::uint32_t>(m_links.size() + 1)};
        const auto trust = m_links.size() + 1 == m_settings.trustedLink ? sim::LinkTrust::Trusted : sim::LinkTrust::Ordinary;
        m_links.push_back(std::make_unique<SimLink>(
            url, id, [this, trust](TimePoint time, const mavlink::Frame &frame) { received(time, frame, trust); }, options));
        link::Link &opened = m_links.back()->link();
        connect(&opened, &link::Link::stateChanged, this, [this, &opened] { report(opened); });
        opened.open();
    }
    if (m_settings.readsStdin) {
        m_stdin = std::make_unique<StdinLines>();
        connect(m_stdin.get(), &StdinLines::lineRead, this, &SimHost::takeLine);
    }
    live();
}

void SimHost::makeVehicles(TimePoint now)
{
    const sim::AutopilotConfig first;
    const sim::GeoFrame field(first.start);
    for (int i = 0; i < m_settings.vehicles; ++i) {
        sim::SimulatedVehicleConfig config;
        config.systemId = static_cast<std::uint8_t>(m_settings.systemId + i);
        config.autopilot.type = m_settings.type;
        config.autopilot.seed = m_settings.seed + static_cast<std::uint64_t>(i);
        const int row = i / 10, column = i % 10;
        config.autopilot.start = field.toGeo({-kSpacing * row, kSpacing * column, 0});
        config.rate = m_settings.rate;
        config.bootTime = wallNow();
        m_vehicles.emplace_back(config, now);
    }
}

void SimHost::received(TimePoint time, const mavlink::Frame &frame, sim::LinkTrust trust)
{
    for (sim::SimulatedVehicle &vehicle : m_vehicles)
        vehicle.handleFrame(time, frame, trust);
    if (m_settings.saturate)
        m_saturator.handleFrame(time, frame);
    if (m_settings.perSecond > 0 && !m_pacer)
        m_pacer.emplace(m_settings.perSecond, time);
    if (m_timer.remainingTime() > 0) // responses do not wait for telemetry
        m_timer.start(0);
}

void SimHost::live()
{
    const TimePoint now = steadyNow();
    TimePoint next = kNever;
    for (sim::SimulatedVehicle &vehicle : m_vehicles) {
        vehicle.advance(now);
        next = std::min(next, vehicle.nextDeadline());
    }
    while (m_settings.saturate && m_saturator.advance(now, m_vehicles.front()))
        send(now);
    if (m_pacer) {
        pace(now);
        next = std::min(next, m_pacer->nextDue());
    }
    send(now);
    const Duration sleep = std::max(next - now, kShortestSleep);
    m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(sleep));
}

void SimHost::pace(TimePoint now)
{
    std::uint64_t first = m_pacer->due();
    for (std::uint64_t left = m_pacer->take(now); left > 0;) {
        send(now); // the outbox is empty
        const std::uint64_t before = dropped(), count = std::min(left, kAtOnce);
        m_vehicles.front().sendTelemetry(now, first, count);
        send(now);
        m_pacer->fail(std::min(count, dropped() - before));
        first += count;
        left -= count;
    }
    if (m_settings.json && now - m_paceReported >= kPaceEvery)
        reportPace(now);
}

/// Frames that did not leave this program.
std::uint64_t SimHost::dropped() const
{
    std::uint64_t out = m_vehicles.front().dropped();
    for (const auto &link : m_links)
        out += link->link().counters().txDropped;
    return out;
}

void SimHost::reportPace(TimePoint now)
{
    m_paceReported = now;
    JsonWriter json;
    json.beginObject().field("event", "pace").field("due", m_pacer->due()).field("missed", m_pacer->missed());
    printLine(json.endObject().text());
}

void SimHost::send(TimePoint now)
{
    for (sim::SimulatedVehicle &vehicle : m_vehicles) {
        for (ByteView frame = vehicle.pollFrame(); !frame.empty(); frame = vehicle.pollFrame()) {
            for (const auto &link : m_links)
                link->send(now, m_framing.framed(frame));
        }
    }
    for (const auto &link : m_links)
        link->flush();
}

/// The first message in a framing is a heartbeat, which tells a reader what it can read. Messages before it are sent as they
/// were.
void SimHost::takeLine(const QByteArray &line)
{
    const std::string word = line.toStdString();
    std::optional<crypto::MavsecKind> kind;
    for (const auto known : {crypto::MavsecKind::ChaCha20, crypto::MavsecKind::Aes256Ctr}) {
        if (word == crypto::name(known))
            kind = known;
    }
    const TimePoint now = steadyNow();
    send(now);
    if ((!kind && word != "plain") || !m_framing.use(kind)) {
        remark("skyseal-sim: standard input: plain, chacha20 or aes-256-ctr is expected");
        return;
    }
    for (sim::SimulatedVehicle &vehicle : m_vehicles)
        vehicle.sendHeartbeat();
    send(now);
    reportFraming();
}

void SimHost::reportFraming() const
{
    if (!m_settings.json)
        return;
    JsonWriter json;
    json.beginObject().field("event", "framing").field("encrypted", m_framing.kind().has_value());
    if (const auto kind = m_framing.kind())
        json.field("cipher", crypto::name(*kind));
    printLine(json.endObject().text());
}

void SimHost::report(link::Link &link)
{
    using State = link::LinkState;
    const State state = link.state();
    if (m_settings.json) {
        JsonWriter json;
        json.beginObject().field("event", "link").field("url", link.url().toText()).field("state", link::name(state));
        json.field("address", link.localAddress());
        if (link.error().code != link::LinkErrorCode::None)
            json.field("problem", link.error().sentence());
        printLine(json.endObject().text());
    }
    const int last = m_settings.systemId + m_settings.vehicles - 1;
    const std::string who = m_settings.vehicles == 1
        ? "vehicle " + std::to_string(last)
        : "vehicles " + std::to_string(m_settings.systemId) + " to " + std::to_string(last);
    if ((state == State::Listening || state == State::Connected) && !m_settings.json)
        printLine("skyseal-sim: " + who + " " + verb(link)
                  + (state == State::Listening ? link.localAddress() : link.url().toText()) + " (" + link.url().type().scheme
                  + ")");
    else if (state == State::Waiting)
        remark("skyseal-sim: " + link.error().sentence() + "; trying again");
    else if (state == State::Failed) {
        remark("skyseal-sim: " + link.error().sentence());
        Q_EMIT failed();
    }
}

} // namespace skyseal::app

#include "moc_sim_host.cpp"
