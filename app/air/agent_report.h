// Output of the agent: one JSON object a line on stdout with --json, sentences for people on stderr otherwise. Main thread.
#pragma once

#include "app/common/output.h"
#include "app/common/pairing_status.h"
#include "core/engine/agent/agent_core.h"
#include "core/engine/agent/repeated_refusals.h"
#include "core/engine/common/peer_names.h"
#include "core/mavlink/enums.h"

#include <string>

namespace skyseal::app {

class AgentReport
{
public:
    explicit AgentReport(bool json);

    void notify(const engine::AgentEvent &event);
    /// A status of the window for pairing.
    void pairing(const PairingStatus &status);
    void stats(const engine::AgentSnapshot &snapshot, double time);
    void summary(const engine::AgentSnapshot &snapshot, double time);

private:
    void say(const std::string &json, const std::string &sentence, unsigned severity = mavlink::MAV_SEVERITY_NOTICE);
    void sayRepeatedRefusals(TimePoint now);
    std::string jsonOf(const engine::AgentEvent &event) const;

    const bool m_json;
    engine::PeerNames m_peers;
    engine::RepeatedRefusals m_refusals; ///< of the sentences; JSON has every event
    UnblockedOutput m_output;            ///< of JSON
};

} // namespace skyseal::app
