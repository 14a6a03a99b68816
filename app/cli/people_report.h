// What a monitor run prints for people: a status line each second in the manner of console ground stations, and a sentence
// for each thing that happens.
#pragma once

#include "core/engine/headless/headless_run.h"

#include <map>
#include <string>

namespace skyseal::app {

/// "Link 1 OK 99.8 % (1204 frames, 2 lost, 0.01 s) | sealed: ChaCha20-Poly1305, epoch 3, air-1, authenticated | …"
std::string statusLine(const engine::Snapshot &snapshot);
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
    std::map<channel::SessionId, std::string> m_peers;
};

} // namespace skyseal::app
