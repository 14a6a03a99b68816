#include "core/engine/headless/channel_event_json.h"

#include "core/engine/headless/common_json.h"
#include "core/engine/headless/event_names.h"
#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"

namespace skyseal::engine {

namespace {

/// Calls the overload for the alternative that an event holds.
class WriteEvent
{
public:
    explicit WriteEvent(const PeerNames &names) : m_names(names) {}

    std::string operator()(const channel::SessionUp &up) const
    {
        JsonWriter json = beginEvent("session");
        json.field("state", "up").field("suite", crypto::suiteInfo(up.suite).name).field("framing", keyword(up.framing));
        json.field("epoch", 0u).field("peer", up.peerName).field("address", link::toText(up.path.remote));
        json.field("carrier", keyword(up.path.carrier));
        return endEvent(json);
    }
    std::string operator()(const channel::SessionDown &down) const
    {
        JsonWriter json = beginEvent("session");
        json.field("state", "down").field("framing", keyword(down.framing)).field("peer", m_names.of(down.session));
        json.field("reason", keyword(down.reason));
        return endEvent(json);
    }
    std::string operator()(const channel::PeerMoved &moved) const
    {
        JsonWriter json = beginEvent("moved");
        json.field("peer", m_names.of(moved.session));
        json.field("from", link::toText(moved.from.remote)).field("to", link::toText(moved.to.remote));
        return endEvent(json);
    }
    std::string operator()(const channel::SwitchPending &) const { return {}; }
    /// A switch of suites, or of keys alone ("rekey").
    std::string operator()(const channel::SwitchDone &done) const
    {
        JsonWriter json = beginEvent(done.rekey ? "rekey" : "switch");
        json.field("from", crypto::suiteInfo(done.from).name).field("to", crypto::suiteInfo(done.to).name);
        json.field("epoch", static_cast<std::uint32_t>(done.epoch));
        json.field("result", done.failure == channel::SwitchFailure::None ? "committed" : "rolled-back");
        if (done.failure != channel::SwitchFailure::None)
            json.field("reason", keyword(done.failure));
        json.field("ms", seconds(done.took) * 1000).field("by_peer", done.byPeer);
        return endEvent(json);
    }
    std::string operator()(const channel::HandshakeRefused &refused) const
    {
        JsonWriter json = beginEvent("refused");
        json.field("reason", keyword(refused.reason)).field("address", link::toText(refused.path.remote));
        if (refused.peer != channel::PublicKey{})
            json.field("fingerprint", keys::fingerprint(refused.peer));
        return endEvent(json);
    }
    std::string operator()(const channel::ForgeryAlarm &alarm) const
    {
        JsonWriter json = beginEvent("forgery");
        json.field("forged", alarm.forged).field("replayed", alarm.replayed);
        return endEvent(json);
    }
    std::string operator()(const channel::CommandsLate &late) const
    {
        JsonWriter json = beginEvent("commands_late");
        json.field("peer", m_names.of(late.session)).field("records", late.records);
        writeFreshness(json, late.report);
        return endEvent(json);
    }
    std::string operator()(const channel::PeerStorageChanged &change) const
    {
        JsonWriter json = beginEvent("agent_storage");
        json.field("peer", m_names.of(change.session)).field("works", !change.failed);
        return endEvent(json);
    }

private:
    const PeerNames &m_names;
};

} // namespace

std::string channelEvent(const channel::Event &event, const PeerNames &names)
{
    return std::visit(WriteEvent(names), event);
}

} // namespace skyseal::engine
