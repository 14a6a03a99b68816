// Snapshots as the engine would make them, for tests and pictures: a copter on a circle above home, sealed or not.
#pragma once

#include "core/engine/station/snapshot.h"

namespace skyseal::ui {

/// The suites that the tests' agent permits: all but the research suite.
std::vector<crypto::SuiteId> usualSuites();

/// As a vehicle reports a mode that its type and autopilot have.
void enterMode(vehicle::VehicleState &state, const std::string &name);

engine::Snapshot waitingSnapshot();
/// Plain vehicle 1 is held back, since the agent air-1 was never heard.
engine::Snapshot pendingApprovalSnapshot();
/// `time` in seconds since the start moves the vehicle along its circle.
engine::Snapshot plainSnapshot(double time);
engine::Snapshot sealedSnapshot(double time, crypto::SuiteId suite = crypto::SuiteId::ChaCha20Poly1305,
                                std::uint32_t epoch = 3);
/// What a recording of a quarter of an hour shows, playing at `position` seconds. Its index has a gap, modes, times armed
/// and cipher switches.
engine::Snapshot replayedSnapshot(double position);
/// Samples of the diagnostics from `fromTime` to `toTime`, four a second, as one suite.
std::vector<engine::MetricsSample> samplesOf(std::uint64_t firstNumber, double fromTime, double toTime, crypto::SuiteId suite,
                                             std::uint32_t epoch);

} // namespace skyseal::ui
