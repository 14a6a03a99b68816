// The state of an agent for reports, as a value.
#pragma once

#include "core/channel/freshness.h"
#include "core/engine/common/link_snapshot.h"
#include "core/engine/common/totals.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {

/// Frames since the start, unless stated otherwise.
struct AgentCounters
{
    std::uint64_t toGround = 0, toVehicle = 0; ///< forwarded
    std::uint64_t observerRefused = 0;         ///< of an observer, other than questions (read-only requests)
    std::uint64_t observerUnclear = 0;         ///< questions that could become another message on a line that loses bytes
    std::uint64_t observerTooOften = 0;        ///< questions beyond QuestionLimit
    std::uint64_t spoofRefused = 0;            ///< of a system that the peer may not use, or of the vehicle's own
    std::uint64_t lateRefused = 0;             ///< of a pilot, in records that arrived too late, other than questions
    std::uint64_t clearRefused = 0;            ///< in clear from the ground; datagrams where they are not searched for frames
    std::uint64_t groundIdRefused = 0;         ///< heartbeats on the vehicle's side under a system id of a ground station
    std::uint64_t undelivered = 0; ///< from the ground while no vehicle is known, from the vehicle without a session
    std::uint64_t unusable = 0;    ///< datagrams from the ground without a record or frame; contained in `malformed`
};

/// MAVLink signing on the vehicle's side, in frames since the start.
struct SigningCounters
{
    std::uint64_t signedFrames = 0;     ///< to the vehicle
    std::uint64_t verified = 0;         ///< of the vehicle
    std::uint64_t unsignedAccepted = 0; ///< of radios, and of others where that is configured
    std::uint64_t unsignedRefused = 0;
    std::uint64_t wrong = 0;          ///< signed with another key, or changed
    std::uint64_t old = 0;            ///< signed with the key, but not newer than earlier ones of the sender
    std::uint64_t unsignable = 0;     ///< of stations: MAVLink 1
    std::uint64_t keyChanges = 0;     ///< of stations: SETUP_SIGNING
    std::uint64_t tooManySenders = 0; ///< of stations, beyond the senders that a vehicle can remember
};

struct AgentSnapshot
{
    LinkSnapshot vehicle;
    std::vector<LinkSnapshot> grounds; ///< in the order of AgentConfig::grounds
    MavlinkTotals mavlink;             ///< frames received from the vehicle
    ChannelTotals channel;
    AgentCounters counters;
    /// Of the session whose commands may be the oldest, with the limits in force; nullopt without a session.
    std::optional<channel::FreshnessReport> freshness;
    std::optional<SigningCounters> signing; ///< if there is a signing key
    Reason storageProblem;                  ///< why the counters of handshakes are not stored; empty if they are
    double processCpuPercent = 0;
    std::uint64_t residentBytes = 0;
};

} // namespace skyseal::engine
