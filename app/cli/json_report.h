// What a monitor run prints with --json: one object a line.
#pragma once

#include "core/engine/headless/headless_run.h"

#include <map>
#include <string>

namespace skyseal::app {

class JsonReport final : public engine::RunListener
{
public:
    void eventOccurred(const engine::Event &event) override;
    void stepEnded(const vehicle::StepReport &report) override;
    void secondPassed(const engine::Snapshot &snapshot, double time) override;
    void ended(const engine::Snapshot &last, double time) override;

private:
    std::string peerName(channel::SessionId session) const;

    std::map<channel::SessionId, std::string> m_peers;
};

} // namespace skyseal::app
