#include "app/air/agent_report.h"

#include "app/common/format.h"
#include "app/common/output.h"
#include "app/common/overloaded.h"
#include "core/engine/headless/agent_json.h"
#include "core/engine/headless/common_json.h"
#include "core/engine/text/agent_event_text.h"
#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"
#include "core/link/steady_now.h"

#include <utility>

namespace skyseal::app {

static constexpr int kSummaryWaitMs = 1000; ///< longest wait at the end for a reader that is slow

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
        remark(format("%u lines of JSON were dropped because the reader did not keep up", std::exchange(m_unread, 0u)));
    printLine(json);
}

void AgentReport::notify(const engine::AgentEvent &event)
{
    if (const auto *common = std::get_if<channel::Event>(&event))
        m_peers.note(*common);
    const engine::EventText text = engine::agentEventText(event, m_peers);
    const auto *refused = std::get_if<engine::FramesRefused>(&event);
    const bool isShown = !text.isRoutine && (!refused || m_refusals.isNew(steadyNow(), *refused));
    say(jsonOf(event), isShown ? text.line().toStdString() : std::string());
}

void AgentReport::sayRepeatedRefusals(TimePoint now)
{
    for (const engine::FramesRefused &refused : m_refusals.takeDue(now))
        say({}, engine::agentEventText(refused, m_peers).line().toStdString());
}

/// Empty for events that scripts are not told.
std::string AgentReport::jsonOf(const engine::AgentEvent &event) const
{
    return std::visit(
        Overloaded{
            [](const engine::AgentLinkChanged &e) { return engine::linkEvent(e.link, e.groundSide ? "ground" : "vehicle"); },
            [this](const channel::Event &e) { return jsonOf(e); },
            [](const channel::PairingEvent &) { return std::string(); }, // pairing() reports it
            [](const engine::FramesRefused &e) { return engine::framesRefusedEvent(e); },
            [](const engine::CounterStorage &e) { return engine::counterStorageEvent(e); },
            [](const engine::GroundIdClaimed &e) { return engine::groundIdClaimedEvent(e); },
        },
        event);
}

std::string AgentReport::jsonOf(const channel::Event &event) const
{
    return std::visit(Overloaded{
                          [](const channel::SessionUp &e) { return engine::sessionUpEvent(e, link::toText(e.path.remote)); },
                          [this](const channel::SessionDown &e) { return engine::sessionDownEvent(e, m_peers.of(e.session)); },
                          [this](const channel::PeerMoved &e) {
                              return engine::peerMovedEvent(m_peers.of(e.session), link::toText(e.from.remote),
                                                            link::toText(e.to.remote));
                          },
                          [](const channel::SwitchPending &) { return std::string(); },
                          [](const channel::SwitchDone &e) { return engine::switchEvent(e); },
                          [](const channel::HandshakeRefused &e) {
                              const std::string fingerprint = e.peer == channel::PublicKey{} ? "" : keys::fingerprint(e.peer);
                              return engine::refusedEvent(e, link::toText(e.path.remote), fingerprint);
                          },
                          [](const channel::ForgeryAlarm &e) { return engine::forgeryEvent(e); },
                          [](const channel::CommandsLate &) { return std::string(); },       // of a station alone
                          [](const channel::PeerStorageChanged &) { return std::string(); }, // likewise
                      },
                      event);
}

void AgentReport::pairing(const PairingStatus &status)
{
    using State = PairingStatus::State;
    std::string sentence;
    if (status.state == State::Open)
        sentence = "The window for pairing is open";
    else if (status.state == State::Paired)
        sentence = "Paired with " + status.name + " (" + keys::fingerprint(status.key) + ")";
    else if (status.state == State::Refused)
        sentence = "Not paired: " + status.reason;
    else if (status.state == State::Over)
        sentence = "The window for pairing is closed" + (status.reason.empty() ? "" : ": " + status.reason);
    say(status.toJson(), sentence);
}

void AgentReport::stats(const engine::AgentSnapshot &snapshot, double time)
{
    sayRepeatedRefusals(steadyNow());
    if (m_json)
        print(engine::agentStatsEvent("stats", snapshot, time));
}

void AgentReport::summary(const engine::AgentSnapshot &snapshot, double time)
{
    sayRepeatedRefusals(kNever);
    if (m_json && hasRoom(stdout, kSummaryWaitMs))
        printLine(engine::agentStatsEvent("summary", snapshot, time));
}

} // namespace skyseal::app
