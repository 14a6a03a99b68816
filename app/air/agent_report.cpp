#include "app/air/agent_report.h"

#include "app/common/format.h"
#include "app/common/event_text.h"
#include "app/common/output.h"
#include "core/engine/headless/agent_json.h"
#include "core/engine/headless/event_json.h"
#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"

#include <utility>

namespace skyseal::app {

static constexpr int kLastWordsMs = 1000; ///< at the end a slow reader is waited for, but not for ever

void AgentReport::say(const std::string &json, const std::string &sentence)
{
    if (m_json && !json.empty())
        print(json);
    else if (!m_json && !sentence.empty() && hasRoom(stderr))
        remark(sentence);
}

void AgentReport::print(const std::string &json)
{
    if (!hasRoom(stdout)) {
        ++m_unread;
        return;
    }
    if (m_unread > 0 && hasRoom(stderr))
        remark(format("%u lines of JSON were left out: nobody read them", std::exchange(m_unread, 0u)));
    printLine(json);
}

std::string AgentReport::peer(channel::SessionId session) const
{
    const auto found = m_peers.find(session);
    return found == m_peers.end() ? std::string() : found->second;
}

void AgentReport::notify(const engine::AgentEvent &event)
{
    if (const auto *changed = std::get_if<engine::AgentLinkChanged>(&event))
        linkChanged(*changed);
    else if (const auto *refused = std::get_if<engine::FramesRefused>(&event))
        framesRefused(*refused);
    else if (const auto *happened = std::get_if<channel::Event>(&event))
        channelEvent(*happened);
}

void AgentReport::linkChanged(const engine::AgentLinkChanged &changed)
{
    const std::string side = changed.groundSide ? "ground" : "vehicle";
    const std::string words = linkText(changed.link);
    say(engine::linkEvent(changed.link, side), words.empty() ? "" : side + " side: " + words);
}

void AgentReport::framesRefused(const engine::FramesRefused &refused)
{
    const bool observer = refused.reason == engine::FramesRefused::Reason::Observer;
    std::string what = refused.messageName.empty() ? "a message that is not known here" : refused.messageName;
    if (refused.command != 0)
        what += format(" %u", unsigned(refused.command));
    say(engine::framesRefusedEvent(refused),
        format("refused %llu frame%s of %s, the last one %s: %s", static_cast<unsigned long long>(refused.frames),
               refused.frames == 1 ? "" : "s", refused.peer.c_str(), what.c_str(),
               observer ? "it may only look" : "it may not speak as that system"));
}

void AgentReport::channelEvent(const channel::Event &event)
{
    if (const auto *up = std::get_if<channel::SessionUp>(&event))
        m_peers[up->session] = up->peerName;
    std::string json;
    if (const auto *up = std::get_if<channel::SessionUp>(&event)) {
        json = engine::sessionUpEvent(*up, link::toText(up->path.remote));
    } else if (const auto *down = std::get_if<channel::SessionDown>(&event)) {
        json = engine::sessionDownEvent(*down, peer(down->session));
    } else if (const auto *moved = std::get_if<channel::PeerMoved>(&event)) {
        json = engine::peerMovedEvent(peer(moved->session), link::toText(moved->from.remote), link::toText(moved->to.remote));
    } else if (const auto *done = std::get_if<channel::SwitchDone>(&event)) {
        json = engine::switchEvent(*done);
    } else if (const auto *refused = std::get_if<channel::HandshakeRefused>(&event)) {
        const std::string fingerprint = refused->peer == channel::PublicKey{} ? "" : keys::fingerprint(refused->peer);
        json = engine::refusedEvent(*refused, link::toText(refused->path.remote), fingerprint);
    } else if (const auto *alarm = std::get_if<channel::ForgeryAlarm>(&event)) {
        json = engine::forgeryEvent(*alarm);
    }
    const engine::Event common = std::visit([](const auto &value) { return engine::Event(value); }, event);
    say(json, sentence(common, m_peers));
    if (const auto *down = std::get_if<channel::SessionDown>(&event))
        m_peers.erase(down->session);
}

void AgentReport::pairing(const PairingStatus &status)
{
    using State = PairingStatus::State;
    std::string words;
    if (status.state == State::Open)
        words = "the window for pairing is open";
    else if (status.state == State::Paired)
        words = "paired with " + status.name + " (" + keys::fingerprint(status.key) + ")";
    else if (status.state == State::Refused)
        words = "not paired: " + status.reason;
    else if (status.state == State::Over)
        words = "the window for pairing is closed" + (status.reason.empty() ? "" : ": " + status.reason);
    say(status.toJson(), words);
}

void AgentReport::stats(const engine::AgentSnapshot &snapshot, double time)
{
    if (m_json)
        print(engine::agentStatsEvent("stats", snapshot, time));
}

void AgentReport::summary(const engine::AgentSnapshot &snapshot, double time)
{
    if (m_json && hasRoom(stdout, kLastWordsMs))
        printLine(engine::agentStatsEvent("summary", snapshot, time));
}

} // namespace skyseal::app
