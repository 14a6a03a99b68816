#include "app/cli/people_report.h"

#include "app/common/format.h"
#include "app/common/journal.h"
#include "app/common/output.h"
#include "core/base/number_text.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/text/event_text.h"
#include "core/engine/text/state_text.h"
#include "core/link/link_url.h"
#include "core/log/link_events.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace skyseal::app {

namespace {

std::string linkText(const engine::Snapshot &snapshot)
{
    if (snapshot.vehicles.empty())
        return "Waiting for a vehicle";
    std::string out;
    for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles) {
        const vehicle::SequenceCounters &count = vehicle.state.sequence;
        const double total = static_cast<double>(count.frames + count.lost);
        const double good = total > 0 ? 100.0 * static_cast<double>(count.frames) / total : 100.0;
        out += format("%sLink %u %s, %s %% arrived (%llu frames, %llu lost, newest %s s ago)", out.empty() ? "" : ", ",
                      unsigned(vehicle.state.systemId), vehicle.state.lost ? "LOST" : "OK", fixedText(good, 1).c_str(),
                      static_cast<unsigned long long>(count.frames), static_cast<unsigned long long>(count.lost),
                      fixedText(vehicle.state.messageAge, 2).c_str());
    }
    return out;
}

/// How the links were protected whose recordings are replayed, as far as it is noted beside them; empty without a recording.
std::string recordedText(const engine::Snapshot &snapshot)
{
    std::string out;
    for (const engine::LinkSnapshot &link : snapshot.links) {
        const auto url = link.recording ? link::LinkUrl::parse(link.url) : tl::make_unexpected(InputError{});
        if (!url)
            continue;
        std::vector<std::string> noted;
        for (const tlog::LinkEvent &event : tlog::linkEventsOf(url->path()).events) {
            const std::string text = event.kind == tlog::LinkEvent::Kind::Plain
                ? "vehicle " + event.peer + " was not sealed"
                : "was sealed: " + event.suite + ", " + event.peer;
            if (std::ranges::find(noted, text) == noted.end())
                noted.push_back(text);
        }
        out += out.empty() ? "replay" : "; replay";
        if (noted.empty())
            out += ", its protection was not noted";
        for (const std::string &text : noted)
            out += ", " + text;
    }
    return out;
}

std::string sealText(const engine::Snapshot &snapshot)
{
    std::string out;
    for (const engine::SessionSnapshot &session : snapshot.sessions) {
        out += format("%s%s, epoch %u, %s, authenticated", out.empty() ? "sealed: " : "; ",
                      engine::suiteText(session.info.suite).toStdString().c_str(), static_cast<unsigned>(session.info.epoch),
                      session.info.peerName.c_str());
        if (session.info.pending)
            out += ", switching to " + engine::suiteText(*session.info.pending).toStdString();
        if (engine::isAttacked(session))
            out += format(", UNDER ATTACK: %llu forged and %llu replayed in a minute",
                          static_cast<unsigned long long>(session.forgedLastMinute),
                          static_cast<unsigned long long>(session.replayedLastMinute));
    }
    for (const engine::UnansweringAgent &agent : snapshot.unanswering)
        out += (out.empty() ? "" : "; ") + agent.peerName + " does not answer";
    if (out.empty() && !snapshot.unknownAgents.empty())
        out = "no session: the agent at " + snapshot.unknownAgents.front().remoteAddress + " is not known here";
    if (out.empty() && snapshot.security != engine::Security::Plain)
        out = recordedText(snapshot);
    if (out.empty())
        out = snapshot.security == engine::Security::Plain ? "NOT SEALED" : "no session";
    return out;
}

std::string flightText(const engine::Snapshot &snapshot)
{
    if (snapshot.vehicles.empty())
        return {};
    const vehicle::VehicleState &state = snapshot.vehicles.front().state;
    std::string out = format(" | %s %s", state.mode.c_str(), state.armed ? "ARMED" : "disarmed");
    if (!std::isnan(state.altitudeRelative))
        out += " " + fixedText(state.altitudeRelative, 1) + " m";
    if (!std::isnan(state.batteryVoltage))
        out += " " + fixedText(state.batteryVoltage, 1) + " V";
    return out;
}

} // namespace

std::string statusLine(const engine::Snapshot &snapshot)
{
    std::string out = linkText(snapshot) + " | " + sealText(snapshot) + flightText(snapshot);
    for (const engine::LinkSnapshot &link : snapshot.links)
        out += " | " + (link.problem.empty() ? link.localAddress : link.problem.text());
    return out;
}

namespace {

std::string lineOf(const engine::EventText &text)
{
    using Remedy = engine::EventText::Remedy;
    if (text.isRoutine)
        return {};
    std::string line = text.line().toStdString();
    switch (text.remedy) {
    case Remedy::None: break;
    case Remedy::AllowPlaintext: return line + ". --secure off accepts plain MAVLink";
    case Remedy::PairAgent:
        return line + ". Pair the two (keys pair; beside the agent skyseal-air --pair), or add its key (keys peers add)";
    }
    return line;
}

} // namespace

std::string eventLine(const engine::Event &event, const engine::PeerNames &peers)
{
    return lineOf(engine::eventText(event, peers));
}

PeopleReport::PeopleReport(const std::string &recordFolder)
{
    if (!recordFolder.empty())
        remark("recording to " + recordFolder);
}

void PeopleReport::eventOccurred(const engine::Event &event)
{
    m_peers.note(event);
    const engine::EventText text = engine::eventText(event, m_peers);
    if (const std::string line = lineOf(text); !line.empty())
        remark(line, text.severity);
}

void PeopleReport::stepEnded(const vehicle::StepReport &report)
{
    remark(report.step + ": " + std::string(vehicle::stepResultName(report.result))
           + (report.reason.empty() ? "" : ", " + report.reason));
}

void PeopleReport::secondPassed(const engine::Snapshot &snapshot, double)
{
    printLine(statusLine(snapshot));
}

void PeopleReport::ended(const engine::Snapshot &last, double time)
{
    const engine::MavlinkTotals &mavlink = last.mavlink;
    const channel::ReceiveCounters &rx = last.channel.rx;
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    printLine(format("%s s: %llu frames, %llu lost, %llu late, %llu duplicate, %llu damaged; records: %llu good, %llu "
                     "lost, %llu replayed, "
                     "%llu forged, %llu clear frames refused",
                     fixedText(time, 1).c_str(), count(mavlink.frames), count(mavlink.lost), count(mavlink.late),
                     count(mavlink.duplicate), count(mavlink.badCrc), count(rx.good), count(rx.lost), count(rx.replayed),
                     count(rx.forged), count(rx.plaintextDropped)));
}

} // namespace skyseal::app
