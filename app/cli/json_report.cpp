#include "app/cli/json_report.h"

#include "app/common/output.h"
#include "core/base/overloaded.h"
#include "core/engine/headless/channel_event_json.h"
#include "core/engine/headless/event_json.h"

namespace skyseal::app {

void JsonReport::eventOccurred(const engine::Event &event)
{
    m_peers.note(event);
    std::visit(Overloaded{
                   [](const engine::LinkChanged &e) { printLine(engine::linkEvent(e.link)); },
                   [](const engine::VehicleFound &e) { printLine(engine::vehicleEvent(e)); },
                   [](const engine::VehicleLost &e) { printLine(engine::vehicleLostEvent(e.systemId, true)); },
                   [](const engine::VehicleBack &e) { printLine(engine::vehicleLostEvent(e.systemId, false)); },
                   [](const vehicle::TextReceived &e) { printLine(engine::statusTextEvent(e)); },
                   [](const engine::PlaintextRefused &e) { printLine(engine::plaintextEvent(e)); },
                   [](const engine::SystemRefused &e) { printLine(engine::systemRefusedEvent(e)); },
                   [](const engine::AgentUnanswering &e) { printLine(engine::unansweringEvent(e)); },
                   [](const engine::RecordingProblem &e) { printLine(engine::recordingEvent(e)); },
                   [](const engine::EventsDropped &e) { printLine(engine::eventsDroppedEvent(e)); },
                   [](const engine::CounterStorage &e) { printLine(engine::counterStorageEvent(e)); },
                   [](const engine::ServedLinkChanged &e) { printLine(engine::servedLinkEvent(e)); },
                   [](const engine::ClientConnected &e) { printLine(engine::clientEvent(e)); },
                   [](const engine::ClientGone &e) { printLine(engine::clientEvent(e)); },
                   [](const engine::ClientDenied &e) { printLine(engine::clientDeniedEvent(e)); },
                   [](const vehicle::MissionResult &) {},
                   [](const vehicle::ParameterResult &) {},
                   [](const vehicle::CommandResult &) {}, // the script reports its steps
                   [this](const auto &e) {                // events of the channel; no others convert to channel::Event
                       if (const std::string line = engine::channelEvent(e, m_peers); !line.empty())
                           printLine(line);
                   },
               },
               event);
}

void JsonReport::stepEnded(const vehicle::StepReport &report)
{
    printLine(engine::commandEvent(report));
}

void JsonReport::secondPassed(const engine::Snapshot &snapshot, double time)
{
    printLine(engine::statsEvent("stats", snapshot, time));
}

void JsonReport::ended(const engine::Snapshot &last, double time)
{
    printLine(engine::statsEvent("summary", last, time));
}

} // namespace skyseal::app
