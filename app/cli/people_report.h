// Report of a monitor run for people: a status line each second, as console ground stations print, and a sentence for each
// event. Main thread.
#pragma once

#include "core/engine/common/peer_names.h"
#include "core/engine/headless/headless_run.h"

#include <string>

namespace skyseal::app {

/// "Link 1 OK 99.8 % (1204 frames, 2 lost, 0.01 s) | sealed: ChaCha20-Poly1305, epoch 3, air-1, authenticated | …"
std::string statusLine(const engine::Snapshot &snapshot);
/// The sentence for an event that `peers` has noted, and the command that helps; empty for a routine event.
std::string eventLine(const engine::Event &event, const engine::PeerNames &peers);

class PeopleReport final : public engine::RunListener
{
public:
    /// `recordFolder` is where the flight is recorded; empty when it is not.
    explicit PeopleReport(const std::string &recordFolder);

    void eventOccurred(const engine::Event &event) override;
    void stepEnded(const vehicle::StepReport &report) override;
    void secondPassed(const engine::Snapshot &snapshot, double time) override;
    void ended(const engine::Snapshot &last, double time) override;

private:
    engine::PeerNames m_peers;
};

} // namespace skyseal::app
