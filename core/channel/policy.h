// Who may talk to us and how: the decisions a person made, as plain values.
#pragma once

#include "core/base/secret_bytes.h"
#include "core/crypto/suite.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::channel {

using PublicKey = std::array<std::uint8_t, 32>;

/// What a known peer may do. An observer receives telemetry; what it sends never reaches the autopilot.
enum class PeerRole : std::uint8_t { Pilot, Observer };

/// A peer whose key a person confirmed.
struct Peer
{
    PublicKey key{};
    std::string name;
    PeerRole role = PeerRole::Pilot;
    std::vector<std::uint8_t> systemIds;                 ///< MAVLink system ids it may speak as; empty = any
    std::shared_ptr<const Key32> presharedKey = nullptr; ///< a second secret that both must have; none = all zero
};

/// What may be negotiated here.
struct Policy
{
    /// In order of preference. Research suites are offered only with `allowResearch` and never chosen first.
    std::vector<crypto::SuiteId> suites;
    bool allowResearch = false;
    /// Consent to plain MAVLink as the baseline of a measurement; the other end must consent as well.
    bool allowPlain = false;
    /// Consent to frames that are sealed in place (inline framing), with an 8-byte tag; used when both ends consent and at
    /// least one of them prefers it, under the suites that can do it.
    bool allowInline = false;
    bool preferInline = false;
};

/// How frames travel: in records, whole and hidden, or sealed in place with their header clear.
enum class Framing : std::uint8_t { Sealed, Inline };

/// All authenticated suites, the default first, research suites last (they need `allowResearch` besides).
std::vector<crypto::SuiteId> defaultSuites();

} // namespace skyseal::channel
