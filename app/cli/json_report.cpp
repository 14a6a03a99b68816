#include "app/cli/json_report.h"

#include "app/common/output.h"
#include "core/engine/headless/event_json.h"

namespace skyseal::app {

void JsonReport::eventOccurred(const engine::Event &event)
{
    m_peers.note(event);
    if (const std::string line = engine::eventJson(event, m_peers); !line.empty())
        printLine(line);
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
