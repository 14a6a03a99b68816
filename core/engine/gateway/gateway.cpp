#include "core/engine/gateway/gateway.h"

#include "core/link/address_text.h"
#include "core/link/steady_now.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

#include <algorithm>
#include <utility>

namespace skyseal::engine {

namespace {

/// The sender of the gateway's texts within a vehicle's system.
constexpr std::uint8_t kGatewayComponent = mavlink::MAV_COMP_ID_UDP_BRIDGE;

mavlink::Statustext textOf(const Denial &denial)
{
    mavlink::Statustext out;
    out.severity = mavlink::MAV_SEVERITY_WARNING;
    const std::string text = "Gateway: " + denial.message + " denied";
    std::copy_n(text.begin(), std::min(text.size(), out.text.size()), out.text.begin());
    return out;
}

} // namespace

Gateway::Gateway(std::vector<ServeConfig> served, Vehicles &vehicles, Notify notify)
    : m_served(std::move(served)), m_budgets(m_served.size()), m_vehicles(vehicles), m_notify(std::move(notify)),
      m_links(*this, [this](link::Link &link) { linkChanged(link); }), m_frames(mavlink::Dialect::builtin())
{}

void Gateway::open()
{
    for (std::size_t i = 0; i < m_served.size(); ++i)
        m_links.open(LinkId(i), m_served[i].url);
}

void Gateway::close()
{
    m_links.flush();
    m_links.forEach([](link::Link &link) {
        link.disconnect();
        link.close();
    });
}

void Gateway::sendToClients(ByteView frame)
{
    for (const auto &[path, client] : m_clients)
        m_links.send(path, frame);
}

void Gateway::everySecond(TimePoint now)
{
    for (auto client = m_clients.begin(); client != m_clients.end();) {
        const auto current = client++;
        reportComing(now, current->first, current->second);
        const link::Link *link = m_links.find(current->first.link);
        if (link->isStream())
            m_links.noteUse(current->first); // including a client that only listens
        else if (!link->traits().isDatagramClient() && current->second.isSilent(now))
            disconnect(current);
    }
    reportUnreported(now);
}

std::vector<ClientSnapshot> Gateway::clients() const
{
    std::vector<ClientSnapshot> out;
    for (const auto &[path, client] : m_clients)
        out.push_back({client.config().name, addressOf(path), client.config().write.toText(), client.counters()});
    return out;
}

void Gateway::linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks)
{
    for (const link::ReceivedBlock &block : blocks)
        receive(link, block);
    m_vehicles.sendForwarded();
}

/// A program that connects by TCP is served at once: it need not send anything.
void Gateway::linkPeerJoined(link::Link &link, const Path &path)
{
    m_frames.forget(path);
    if (configOf(link.id()).isFrom(path.remote) && !m_clients.contains(path))
        connect(steadyNow(), path);
}

void Gateway::linkPeerLeft(link::Link &, const Path &path)
{
    m_frames.forget(path);
    if (const auto client = m_clients.find(path); client != m_clients.end())
        disconnect(client);
}

void Gateway::linkChanged(link::Link &link)
{
    // The URL of a link to one address names its client.
    const Path configured{link.id(), {}};
    if (link.traits().isDatagramClient()) {
        const auto client = m_clients.find(configured);
        if (link.state() == link::LinkState::Connected && client == m_clients.end())
            connect(steadyNow(), configured);
        else if (link.state() != link::LinkState::Connected && client != m_clients.end())
            disconnect(client);
    }
    m_notify(ServedLinkChanged{m_links.snapshot(link)});
}

void Gateway::receive(const link::Link &link, const link::ReceivedBlock &block)
{
    const bool isConfigured = link.traits().isDatagramClient(); // the URL names the only client
    if (isConfigured ? block.path.remote != link.remote() : !configOf(link.id()).isFrom(block.path.remote))
        return;
    const Path path = isConfigured ? Path{link.id(), {}} : block.path;
    const auto deliver = [&](const mavlink::ScanItem &item) {
        if (mavlink::isDamagedFrame(item))
            m_links.countBadFrame(path.link);
        if (!mavlink::isWholeFrame(item))
            return;
        if (Client *client = clientAt(block.time, link, path)) {
            m_links.noteUse(block.path);
            takeFrame(block.time, path, *client, item);
        }
    };
    if (link.isStream())
        m_frames.takeStream(path, block.bytes, deliver);
    else
        m_frames.takeDatagram(block.time, path, block.bytes, deliver);
}

/// The client at this path. The first frame from a new address adds one, if there is room.
Client *Gateway::clientAt(TimePoint now, const link::Link &link, const Path &path)
{
    if (const auto known = m_clients.find(path); known != m_clients.end())
        return &known->second;
    return makeRoom(now, link, path.remote) ? &connect(now, path) : nullptr;
}

/// Returns false if all places of the link are taken. On streams, the link itself limits the connections.
bool Gateway::makeRoom(TimePoint now, const link::Link &link, const Address &newcomer)
{
    std::vector<ClientPlace> places;
    for (const auto &[path, client] : m_clients) {
        if (path.link == link.id())
            places.push_back({path, client.heardAt()});
    }
    if (places.size() < kMostClients)
        return true;
    const auto freed = link.isStream() ? std::nullopt : placeToFree(places, newcomer, now);
    if (freed)
        disconnect(m_clients.find(*freed));
    return freed.has_value();
}

Client &Gateway::connect(TimePoint now, const Path &path)
{
    const auto link = static_cast<std::size_t>(path.link);
    Client &client = m_clients.try_emplace(path, m_served[link], m_budgets[link]).first->second;
    client.noteHeard(now);
    reportComing(now, path, client);
    return client;
}

void Gateway::disconnect(std::map<Path, Client>::iterator client)
{
    const bool reported = client->second.isReported();
    ClientGone gone{client->second.config().name, addressOf(client->first)};
    m_clients.erase(client);
    if (reported)
        m_notify(std::move(gone));
    else
        ++m_unreported.clients;
}

void Gateway::reportComing(TimePoint now, const Path &path, Client &client)
{
    if (client.isReported() || !mayReport(now))
        return;
    client.setReported();
    m_notify(ClientConnected{client.config().name, addressOf(path), client.config().write.toText()});
}

void Gateway::reportUnreported(TimePoint now)
{
    if ((m_unreported.clients == 0 && m_unreported.frames == 0) || now < m_reportUnreportedAt)
        return;
    m_reportUnreportedAt = now + kReportUnreportedEvery;
    m_notify(std::exchange(m_unreported, {}));
}

void Gateway::takeFrame(TimePoint now, const Path &from, Client &client, const mavlink::ScanItem &item)
{
    const std::uint8_t target = item.frame ? item.frame->targetSystem() : 0;
    const bool pilotThere = std::ranges::any_of(m_clients, [](const auto &other) { return other.second.config().write.any(); });
    switch (client.judge(now, item, m_vehicles.isVehicle(mavlink::systemIdOf(item.bytes)), pilotThere)) {
    case Client::Verdict::Forward: return m_vehicles.forward(now, target, item.bytes);
    case Client::Verdict::Deny: return deny(now, from, client, item);
    case Client::Verdict::Ignore:
    case Client::Verdict::TooOften:
    case Client::Verdict::NotItsSystem: return;
    }
}

void Gateway::deny(TimePoint now, const Path &to, Client &client, const mavlink::ScanItem &item)
{
    if (item.frame)
        answerCommand(to, *item.frame);
    const auto denial = client.takeDenial(now, item);
    if (!denial)
        return;
    if (item.frame)
        answer(to, *item.frame, kGatewayComponent, textOf(*denial));
    if (mayReport(now))
        m_notify(ClientDenied{client.config().name, addressOf(to), denial->message, denial->frames});
    else
        m_unreported.frames += denial->frames;
}

void Gateway::answerCommand(const Path &to, const mavlink::Frame &frame)
{
    mavlink::CommandAck ack;
    if (frame.messageId() == mavlink::CommandLong::kId)
        ack.command = mavlink::CommandLong::decode(frame.payload()).command;
    else if (frame.messageId() == mavlink::CommandInt::kId)
        ack.command = mavlink::CommandInt::decode(frame.payload()).command;
    else
        return;
    ack.result = mavlink::MAV_RESULT_DENIED;
    ack.target_system = frame.systemId();
    ack.target_component = frame.componentId();
    const std::uint8_t target = frame.targetComponent();
    answer(to, frame, target ? target : std::uint8_t(mavlink::MAV_COMP_ID_AUTOPILOT1), ack);
}

/// Answers a frame in the name of its target, in the frame's version of MAVLink.
template<typename Message>
void Gateway::answer(const Path &to, const mavlink::Frame &frame, std::uint8_t component, const Message &message)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const std::uint8_t system = frame.targetSystem() ? frame.targetSystem() : std::uint8_t(1);
    m_links.send(to, mavlink::FrameWriter(system, component, frame.version()).write(message, buffer));
    m_links.flush();
}

std::string Gateway::addressOf(const Path &path) const
{
    const link::Link *link = m_links.find(path.link);
    return link::toText(path.remote == Address() && link ? link->remote() : path.remote);
}

} // namespace skyseal::engine
