#include "app/cli/json_report.h"

#include "app/common/overloaded.h"
#include "app/common/output.h"
#include "core/engine/headless/event_json.h"
#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"

namespace skyseal::app {

void JsonReport::eventOccurred(const engine::Event &event)
{
    m_peers.note(event);
    std::visit(
        Overloaded{
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
            [](const vehicle::MissionResult &) {},
            [](const vehicle::ParameterResult &) {},
            [](const vehicle::CommandResult &) {}, // the script reports its steps
            [](const channel::SessionUp &e) { printLine(engine::sessionUpEvent(e, link::toText(e.path.remote))); },
            [this](const channel::SessionDown &e) { printLine(engine::sessionDownEvent(e, m_peers.of(e.session))); },
            [this](const channel::PeerMoved &e) {
                printLine(
                    engine::peerMovedEvent(m_peers.of(e.session), link::toText(e.from.remote), link::toText(e.to.remote)));
            },
            [](const channel::SwitchPending &) {},
            [](const channel::SwitchDone &e) { printLine(engine::switchEvent(e)); },
            [](const channel::HandshakeRefused &e) {
                const std::string fingerprint = e.peer == channel::PublicKey{} ? "" : keys::fingerprint(e.peer);
                printLine(engine::refusedEvent(e, link::toText(e.path.remote), fingerprint));
            },
            [](const channel::ForgeryAlarm &e) { printLine(engine::forgeryEvent(e)); },
            [this](const channel::CommandsLate &e) { printLine(engine::commandsLateEvent(e, m_peers.of(e.session))); },
            [this](const channel::PeerStorageChanged &e) { printLine(engine::peerStorageEvent(e, m_peers.of(e.session))); },
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
