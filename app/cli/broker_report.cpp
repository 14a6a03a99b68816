#include "app/cli/broker_report.h"

#include "app/common/journal.h"
#include "app/common/output.h"
#include "core/engine/headless/event_json.h"
#include "core/engine/station/snapshot.h"

namespace skyseal::app {

void BrokerReport::take(const engine::Snapshot &snapshot)
{
    if (!snapshot.broker || (snapshot.broker->connected == m_connected && snapshot.broker->problem == m_problem))
        return;
    m_connected = snapshot.broker->connected;
    m_problem = snapshot.broker->problem;
    if (m_json)
        printLine(engine::brokerEvent(m_url, *snapshot.broker));
    else if (m_connected)
        remark(m_url + ": connected", mavlink::MAV_SEVERITY_INFO);
    else
        remark(m_url + ": " + (m_problem.empty() ? "not connected" : m_problem) + "; trying again",
               mavlink::MAV_SEVERITY_WARNING);
}

} // namespace skyseal::app
