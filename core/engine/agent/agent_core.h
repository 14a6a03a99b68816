// The agent's engine: sits beside an autopilot that knows nothing of sealing, speaks plain MAVLink with it and the sealed
// protocol with the ground, and carries whole frames both ways as they are. It adds nothing of its own: when the sealed link
// dies the autopilot hears no station any more, and its own failsafe acts.
//
// Lives on one thread with an event loop.
#pragma once

#include "core/engine/common/carrier_reader.h"
#include "core/engine/common/channel_driver.h"
#include "core/engine/agent/clear_packet.h"
#include "core/engine/common/deadline_timer.h"
#include "core/engine/common/sealed_in_place.h"
#include "core/mavlink/frame_intake.h"
#include "core/engine/common/link_pool.h"
#include "core/engine/common/pairing_driver.h"
#include "core/engine/common/secret_files.h"
#include "core/engine/common/sender_policy.h"
#include "core/engine/agent/vehicle_routes.h"
#include "core/metrics/process_usage.h"
#include "core/metrics/sequence_table.h"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <variant>

namespace skyseal::engine {

struct AgentConfig
{
    link::LinkUrl vehicle;
    link::LinkUrl ground;
    channel::Policy policy;
    /// Consent to carry clear MAVLink while no session is up: the baseline of a measurement.
    bool allowPlain = false;
    /// In what sealed messages travel on the ground link: datagrams want a link of datagrams, COBS a stream; TUNNEL takes
    /// both.
    Carrier carrier = Carrier::Datagram;
};

struct AgentLinkChanged
{
    bool groundSide = false;
    LinkSnapshot link;
};
/// Frames of an authenticated peer that did not reach the vehicle; told once a snapshot and peer. An observer's heartbeats
/// are only counted.
struct FramesRefused
{
    enum class Reason : std::uint8_t { Observer, System };
    Reason reason{};
    std::string peer;
    std::uint32_t messageId = 0; ///< of the newest of them
    std::string messageName;     ///< empty when it is not known here
    std::uint16_t command = 0;   ///< of a COMMAND_LONG or COMMAND_INT
    std::uint64_t frames = 0;
};
/// What the owner is told, as it happens.
using AgentEvent = std::variant<AgentLinkChanged, channel::Event, channel::PairingEvent, FramesRefused>;

/// Why the window for pairing was not opened.
enum class PairingRefusal : std::uint8_t { Armed, OpenAlready };

struct AgentCounters
{
    std::uint64_t toGround = 0, toVehicle = 0; ///< frames carried
    std::uint64_t observerRefused = 0;         ///< frames of a peer that may only look, but for harmless questions
    std::uint64_t observerUnclear = 0; ///< of these questions, what a line that loses bytes could turn into something else
    std::uint64_t spoofRefused = 0;    ///< frames of a system that their peer may not speak as, or of the vehicle itself
    std::uint64_t clearRefused = 0;    ///< clear frames from the ground
    std::uint64_t undelivered = 0;     ///< from the ground while no vehicle is known, from the vehicle without a session
};

struct AgentSnapshot
{
    LinkSnapshot vehicle, ground;
    MavlinkTotals mavlink; ///< what came from the vehicle
    ChannelTotals channel;
    AgentCounters counters;
    double processCpuPercent = 0;
    std::uint64_t residentBytes = 0;
};

class AgentCore : private link::LinkListener
{
public:
    using Tell = std::function<void(const AgentEvent &)>;

    AgentCore(AgentConfig config, std::unique_ptr<SecretFiles> secrets, Tell tell);
    ~AgentCore() override;

    void start();
    /// A new list of those who may connect; sessions of keys that are no longer in it end at once.
    void setPeers(std::vector<channel::Peer> peers);
    /// Opens the window in which a new station can be paired, until it is over or the vehicle is armed. What happens in it
    /// comes as events; `name` is what we call ourselves. A vehicle that was never heard does not count as armed, one
    /// that fell silent counts as what it last was. `passphraseKey` is of channel::pairingPassphraseKey(), null without one.
    Result<void, PairingRefusal> openPairing(std::string name, std::shared_ptr<const Key32> passphraseKey = {});
    void confirmPairing(const channel::PublicKey &key);
    void refusePairing();
    void cancelPairing();
    const channel::PublicKey &publicKey() const { return m_secrets->identity->publicKey; }
    /// Says goodbye to every station.
    void stop();
    /// Call about once a second: rates and load are over the time since the last call.
    AgentSnapshot snapshot();

private:
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void linkPeerJoined(link::Link &link, const Path &path) override;
    void linkPeerLeft(link::Link &link, const Path &path) override;
    void linkChanged(link::Link &link);

    void takeGround(const link::Link &link, const link::ReceivedBlock &block);
    void takeMessage(const link::ReceivedBlock &block);
    void becomeNode(TimePoint now, std::uint8_t systemId);
    void beat(TimePoint now);
    void takeFromVehicle(TimePoint now, const Path &from, const mavlink::ScanItem &item);
    void takeRecord(const link::ReceivedBlock &block);
    void takeUnowned(const link::ReceivedBlock &block);
    void takeDelivery(const link::ReceivedBlock &block, const channel::Delivery &delivery);
    void countFromGround(TimePoint now, channel::SessionId session, const mavlink::ScanItem &item);
    void takeFromGround(channel::SessionId session, const mavlink::ScanItem &item);
    void takeClearFromGround(const Path &from, const mavlink::ScanItem &item);
    void refuse(channel::SessionId session, const mavlink::ScanItem &item, FramesRefused::Reason reason);
    void deliver(const mavlink::ScanItem &item);
    void noteArmed(TimePoint now, const mavlink::Frame &frame);
    void handleEvents(std::optional<channel::SessionId> speaking = {});
    void handleDeadline();
    void finishWake();

    AgentConfig m_config;
    std::unique_ptr<SecretFiles> m_secrets;
    Tell m_notify;
    Path m_ground; ///< where stations are looked for; the address is known once a name was looked up
    LinkPool m_links;
    ChannelDriver m_channel;
    PairingDriver m_pairing;
    SenderPolicy m_policy;
    mavlink::FrameIntake m_intake;
    CarrierReader m_carriers;
    ClearPacket m_clear; ///< to the ground
    VehicleRoutes m_routes;
    metrics::SequenceTable m_sequences;
    std::map<channel::SessionId, metrics::SequenceTable> m_fromGround; ///< each station counts its own frames
    metrics::CpuSampler m_cpu;
    AgentCounters m_counters;
    std::map<std::pair<channel::SessionId, FramesRefused::Reason>, FramesRefused> m_refusedPending;
    std::vector<channel::SessionId> m_sessions;
    std::uint64_t m_garbage = 0;
    std::set<std::pair<std::uint8_t, std::uint8_t>> m_armed; ///< systems and components, each as its heartbeat said last
    TimePoint m_beatDue = kNever;                            ///< while nobody knows as whom
    bool m_stopped = false;
    DeadlineTimer m_timer;
};

} // namespace skyseal::engine
