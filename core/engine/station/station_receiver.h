// The station's treatment of received messages: records are opened by the channel, clear frames judged by FrameGate, and
// accepted frames passed to the fleet, the routes and the recorder. I/O thread.
#pragma once

#include "core/channel/interval_limit.h"
#include "core/engine/common/ingress.h"
#include "core/engine/common/link_pool.h"
#include "core/engine/gateway/gateway.h"
#include "core/engine/station/bare_sink.h"
#include "core/engine/station/call_places.h"
#include "core/engine/station/datagram_counters.h"
#include "core/engine/station/feed.h"
#include "core/engine/station/fleet.h"
#include "core/engine/station/frame_gate.h"
#include "core/engine/station/mavsec_sink.h"
#include "core/engine/station/recorder.h"
#include "core/engine/station/route_table.h"
#include "core/engine/station/security_settings.h"
#include "core/engine/station/station_channel.h"

#include <bitset>
#include <map>
#include <optional>

namespace skyseal::engine {

class StationReceiver final : private IngressSink
{
public:
    /// Handles the events of the channel, except the end of the session `speaking` and later ones.
    class EventHandler
    {
    public:
        virtual ~EventHandler() = default;
        virtual void handleEvents(TimePoint now, std::optional<channel::SessionId> speaking) = 0;
    };
    /// The parts that a receiver works on; all must outlive it.
    struct Parts
    {
        LinkPool &links;
        Ingress &ingress;
        Fleet &fleet;
        RouteTable &routes;
        const SecuritySettings &settings;
        Notify notify;
        EventHandler &events;
    };

    /// `self`: frames of this system and component are our own, looped back.
    StationReceiver(Node self, const Parts &parts) : m_self(self), m_parts(parts), m_gate(parts.settings.mode()) {}

    /// The channel, null without keys; it must outlive this object.
    void setChannel(StationChannel *channel) { m_channel = channel; }
    /// Null when nothing is recorded.
    void setRecorder(Recorder *recorder)
    {
        m_recorder = recorder;
        m_notedPlain.reset();
    }
    /// Receives the accepted frames of vehicles; null when no clients are served.
    void setGateway(Gateway *gateway) { m_gateway = gateway; }

    /// Receives them as well; null when nothing is published.
    void setFeed(Feed *feed) { m_feed = feed; }

    FrameGate &gate() { return m_gate; }
    const FrameGate &gate() const { return m_gate; }
    const DatagramCounters &datagrams() const { return m_datagrams; }
    CallPlaces &callPlaces() { return m_callPlaces; }

    /// Call before the link opens.
    void addLink(LinkId id, const link::LinkTraits &traits);
    void addMavsecLink(LinkId id, const link::LinkTraits &traits, crypto::MavsecCipher cipher);
    /// For a measurement: clear frames on live links are those of a vehicle that encrypts their payloads; nullopt: no longer.
    void setBareCipher(std::optional<crypto::MavsecCipher> &&cipher);
    /// Call after the link was closed.
    void removeLink(LinkId id);
    /// Call when the protection in force has changed: the classification of blocks depends on it.
    void updateRules();

private:
    /// Receives from links that replay a log, which carry only frames in clear.
    class RecordingSink final : public IngressSink
    {
    public:
        explicit RecordingSink(StationReceiver &receiver) : m_receiver(receiver) {}
        void takeClear(const link::Link &, const link::ReceivedBlock &block, const mavlink::ScanItem &item) override
        {
            m_receiver.takeClearItem(block, item, FrameOrigin::Recording);
        }
        void takeUnusable(const link::Link &link, Unusable what) override { m_receiver.takeUnusable(link, what); }

    private:
        StationReceiver &m_receiver;
    };

    bool takePairing(const link::Link &link, const link::ReceivedBlock &message) override;
    bool namesSession(ByteView message) const override;
    bool takeRecord(const link::Link &link, const link::ReceivedBlock &message) override;
    void takeSealedInPlace(const link::Link &link, const link::ReceivedBlock &frame) override;
    void takeClear(const link::Link &link, const link::ReceivedBlock &block, const mavlink::ScanItem &item) override;
    void takeUnusable(const link::Link &link, Unusable what) override;

    void takeDelivery(const link::ReceivedBlock &block, const channel::Delivery &delivery);
    void takeClearItem(const link::ReceivedBlock &block, const mavlink::ScanItem &item, FrameOrigin origin);
    void takeClearFrame(TimePoint now, const Path &from, const mavlink::Frame &frame, FrameOrigin origin);
    void acceptFrame(TimePoint now, const Path &from, const mavlink::Frame &frame, FrameOrigin origin,
                     std::optional<channel::SessionId> session);
    void acceptLateFrame(TimePoint now, const Path &from, const mavlink::Frame &frame, channel::Freshness freshness);
    void refuseFrame(const link::ReceivedBlock &block, const mavlink::Frame &frame, channel::SessionId session);
    void takeUnknownMessage(const channel::Delivery &delivery, ByteView frame);
    void record(const mavlink::Frame &frame, WallTime wall);
    void notePlain(const mavlink::Frame &frame, WallTime wall);
    void serve(ByteView frame)
    {
        if (m_gateway)
            m_gateway->sendToClients(frame);
        if (m_feed)
            m_feed->takeFrame(frame);
    }
    IngressSink &sinkFor(const link::LinkTraits &traits);
    IngressRules rulesFor(const link::LinkTraits &traits) const;
    bool isSealing() const { return m_channel && !m_parts.settings.isPlain(); }

    const Node m_self;
    const Parts m_parts;
    StationChannel *m_channel = nullptr;
    Recorder *m_recorder = nullptr;
    std::bitset<256> m_notedPlain; ///< system IDs of which the recording says that they are heard in clear
    Gateway *m_gateway = nullptr;
    Feed *m_feed = nullptr;
    FrameGate m_gate;
    RecordingSink m_recordings{*this};
    std::map<LinkId, MavsecSink> m_mavsec;
    DatagramCounters m_datagrams;
    std::optional<BareSink> m_bare;
    CallPlaces m_callPlaces;
    channel::IntervalLimit m_ownIdLimit{std::chrono::minutes(1), TimePoint::min()}; ///< of OwnIdClaimed
};

} // namespace skyseal::engine
