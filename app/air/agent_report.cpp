#include "app/air/agent_report.h"

#include "app/common/format.h"
#include "app/common/journal.h"
#include "app/common/output.h"
#include "core/base/overloaded.h"
#include "core/engine/headless/agent_json.h"
#include "core/engine/headless/channel_event_json.h"
#include "core/engine/headless/common_json.h"
#include "core/engine/text/agent_event_text.h"
#include "core/engine/text/pairing_text.h"
#include "core/keys/public_key_text.h"
#include "core/link/steady_now.h"

namespace skyseal::app {

AgentReport::AgentReport(bool json) : m_json(json) {}

void AgentReport::say(const std::string &json, const std::string &sentence, unsigned severity)
{
    if (m_json && !json.empty())
        m_output.print(json);
    else if (!m_json && !sentence.empty() && hasRoom(stderr))
        remark(sentence, severity);
}

void AgentReport::notify(const engine::AgentEvent &event)
{
    if (const auto *common = std::get_if<channel::Event>(&event))
        m_peers.note(*common);
    const engine::EventText text = engine::agentEventText(event, m_peers);
    const auto *refused = std::get_if<engine::FramesRefused>(&event);
    const bool isShown = !text.isRoutine && (!refused || m_refusals.isNew(steadyNow(), *refused));
    say(jsonOf(event), isShown ? text.line().toStdString() : std::string(), text.severity);
}

void AgentReport::sayRepeatedRefusals(TimePoint now)
{
    for (const engine::FramesRefused &refused : m_refusals.takeDue(now)) {
        const engine::EventText text = engine::agentEventText(refused, m_peers);
        say({}, text.line().toStdString(), text.severity);
    }
}

/// Empty for events that are not reported to scripts.
std::string AgentReport::jsonOf(const engine::AgentEvent &event) const
{
    return std::visit(
        Overloaded{
            [](const engine::AgentLinkChanged &e) { return engine::linkEvent(e.link, e.groundSide ? "ground" : "vehicle"); },
            [this](const channel::Event &e) { return engine::channelEvent(e, m_peers); },
            [](const channel::PairingEvent &) { return std::string(); }, // pairing() reports it
            [](const engine::FramesRefused &e) { return engine::framesRefusedEvent(e); },
            [](const engine::VehicleSignatures &e) { return engine::vehicleSigningEvent(e); },
            [](const engine::CounterStorage &e) { return engine::counterStorageEvent(e); },
            [](const engine::GroundIdClaimed &e) { return engine::groundIdClaimedEvent(e); },
        },
        event);
}

void AgentReport::pairing(const PairingStatus &status)
{
    using State = PairingStatus::State;
    std::string sentence;
    if (status.state == State::Open)
        sentence = "The pairing window is open";
    else if (status.state == State::Paired)
        sentence = engine::pairedText(QString::fromStdString(status.name)).toStdString() + " (" + keys::fingerprint(status.key)
            + ")";
    else if (status.state == State::Refused)
        sentence = engine::notPairedText(QString::fromStdString(status.reason)).toStdString();
    else if (status.state == State::Over)
        sentence = "The pairing window is closed" + (status.reason.empty() ? "" : ": " + status.reason);
    say(status.toJson(), sentence);
}

void AgentReport::stats(const engine::AgentSnapshot &snapshot, double time)
{
    sayRepeatedRefusals(steadyNow());
    if (m_json)
        m_output.print(engine::agentStatsEvent("stats", snapshot, time));
}

void AgentReport::summary(const engine::AgentSnapshot &snapshot, double time)
{
    sayRepeatedRefusals(kNever);
    if (m_json)
        m_output.printLast(engine::agentStatsEvent("summary", snapshot, time));
}

} // namespace skyseal::app
