// Serves other ground stations and programs: they receive the frames of the vehicles byte for byte, as the autopilots sent
// them, and their permitted frames are forwarded to the vehicles unchanged, neither signed nor renumbered. Part of the
// station's engine; the links of vehicles may be sealed, those of clients are not. I/O thread.
//
// A denied command is answered by COMMAND_ACK in the name of its target, since stations expect the answer of the component
// that they addressed. Its sequence number is not the autopilot's, so such a client counts up to 255 lost frames. A STATUSTEXT,
// at most once a minute, names the denied message.
#pragma once

#include "core/engine/common/link_pool.h"
#include "core/engine/gateway/client.h"
#include "core/engine/gateway/client_places.h"
#include "core/engine/gateway/gateway_event.h"
#include "core/mavlink/frame_intake.h"

#include <functional>
#include <map>
#include <vector>

namespace skyseal::engine {

class Gateway final : private link::LinkListener
{
public:
    /// The vehicles that are served.
    class Vehicles
    {
    public:
        virtual ~Vehicles() = default;
        virtual bool isVehicle(std::uint8_t systemId) const = 0;
        /// Queues a frame of a client for a system; 0: for all.
        virtual void forward(TimePoint now, std::uint8_t systemId, ByteView frame) = 0;
        /// Sends the queued frames. Called once for each batch of received frames.
        virtual void sendForwarded() = 0;
    };
    using Notify = std::function<void(GatewayEvent)>;

    /// Greatest number of clients of each link whose addresses are not configured.
    static constexpr std::size_t kMostClients = 32;
    /// Limit of the reports of connected, disconnected and denied clients: this many at once, then one a second, since anyone
    /// who reaches the port can connect repeatedly. The others are counted and reported together.
    static constexpr double kReportsAtOnce = 64, kReportsPerSecond = 1;
    static constexpr Duration kReportUnreportedEvery = std::chrono::minutes(1);

    /// `vehicles` must outlive this object.
    Gateway(std::vector<ServeConfig> served, Vehicles &vehicles, Notify notify);

    /// Opens the links.
    void open();
    /// Queues a frame of a vehicle for all clients.
    void sendToClients(ByteView frame);
    /// Sends the queued frames.
    void flush() { m_links.flush(); }
    /// Forgets silent clients, and publishes the reports that were postponed. Call about once a second.
    void everySecond(TimePoint now);
    void close();

    std::vector<LinkSnapshot> links(TimePoint now) { return m_links.snapshots(now); }
    std::vector<ClientSnapshot> clients() const;

private:
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void linkPeerJoined(link::Link &link, const Path &path) override;
    void linkPeerLeft(link::Link &link, const Path &path) override;
    void linkChanged(link::Link &link);

    const ServeConfig &configOf(LinkId link) const { return m_served[static_cast<std::size_t>(link)]; }
    void receive(const link::Link &link, const link::ReceivedBlock &block);
    Client *clientAt(TimePoint now, const link::Link &link, const Path &path);
    bool makeRoom(TimePoint now, const link::Link &link, const Address &newcomer);
    Client &connect(TimePoint now, const Path &path);
    void disconnect(std::map<Path, Client>::iterator client);
    bool mayReport(TimePoint now) { return m_reports.take(now, kReportsPerSecond, kReportsAtOnce); }
    void reportComing(TimePoint now, const Path &path, Client &client);
    void reportUnreported(TimePoint now);
    void takeFrame(TimePoint now, const Path &from, Client &client, const mavlink::ScanItem &item);
    void deny(TimePoint now, const Path &to, Client &client, const mavlink::ScanItem &item);
    void answerCommand(const Path &to, const mavlink::Frame &frame);
    template<typename Message>
    void answer(const Path &to, const mavlink::Frame &frame, std::uint8_t component, const Message &message);
    std::string addressOf(const Path &path) const;

    const std::vector<ServeConfig> m_served; ///< the link's id is the index
    std::vector<QuestionBudget> m_budgets;   ///< of each link, so that reconnecting does not raise the limit
    Vehicles &m_vehicles;
    Notify m_notify;
    LinkPool m_links;
    mavlink::FrameIntake m_frames;
    std::map<Path, Client> m_clients;
    channel::TokenBucket m_reports;
    ClientsUnreported m_unreported;
    TimePoint m_reportUnreportedAt = TimePoint::min();
};

} // namespace skyseal::engine
