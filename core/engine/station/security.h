// The security state of a station in one word, for the lock symbol and the alarms.
#pragma once

#include <cstdint>

namespace skyseal::engine {

/// The security state that the operator must see at a glance.
enum class Security : std::uint8_t {
    Nothing, ///< no vehicle and no session, or nothing but a recording
    Plain,   ///< clear MAVLink: "not sealed"
    Sealed,
    Switching,  ///< sealed, and a switch of suites is in progress
    UnderAttack ///< sealed, and records are forged or replayed; see isAttacked()
};

struct Snapshot;
struct VehicleSnapshot;

/// True if the vehicle is heard by a recording alone: its frames are in clear, whatever protected them on their way.
bool isRecorded(const Snapshot &snapshot, const VehicleSnapshot &vehicle);

/// Derives the security state from the sessions and vehicles of a snapshot.
Security securityOf(const Snapshot &snapshot);

} // namespace skyseal::engine
