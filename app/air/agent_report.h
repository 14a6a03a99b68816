// What the agent says: one JSON object a line on stdout with --json, sentences for people on stderr otherwise.
#pragma once

#include "app/common/pairing_status.h"
#include "core/engine/agent/agent_core.h"

#include <map>
#include <string>

namespace skyseal::app {

class AgentReport
{
public:
    explicit AgentReport(bool json) : m_json(json) {}

    void notify(const engine::AgentEvent &event);
    /// What is told where the window for pairing was opened.
    void pairing(const PairingStatus &status);
    void stats(const engine::AgentSnapshot &snapshot, double time);
    void summary(const engine::AgentSnapshot &snapshot, double time);

private:
    void say(const std::string &json, const std::string &sentence);
    void print(const std::string &json);
    void linkChanged(const engine::AgentLinkChanged &changed);
    void framesRefused(const engine::FramesRefused &refused);
    void channelEvent(const channel::Event &event);
    std::string peer(channel::SessionId session) const;

    bool m_json;
    std::map<channel::SessionId, std::string> m_peers;
    unsigned m_unread = 0; ///< lines that found no room
};

} // namespace skyseal::app
