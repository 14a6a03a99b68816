// Report of a monitor run with --json: one object a line. Main thread.
#pragma once

#include "core/engine/common/peer_names.h"
#include "core/engine/headless/headless_run.h"

namespace skyseal::app {

class JsonReport final : public engine::RunListener
{
public:
    void eventOccurred(const engine::Event &event) override;
    void stepEnded(const vehicle::StepReport &report) override;
    void secondPassed(const engine::Snapshot &snapshot, double time) override;
    void ended(const engine::Snapshot &last, double time) override;

private:
    engine::PeerNames m_peers;
};

} // namespace skyseal::app
