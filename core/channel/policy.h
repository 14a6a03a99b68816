// Known peers and the negotiation policy: decisions of the user, as plain values.
#pragma once

#include "core/base/secret_bytes_fwd.h"
#include "core/crypto/public_key.h"
#include "core/crypto/suite.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::channel {

using crypto::PublicKey;

/// The rights of a known peer. An observer receives telemetry; of its messages, only read-only requests reach the autopilot.
enum class PeerRole : std::uint8_t { Pilot, Observer };

/// A peer whose key was confirmed by the user.
struct Peer
{
    PublicKey key{};
    std::string name;
    PeerRole role = PeerRole::Pilot;
    std::vector<std::uint8_t> systemIds;                 ///< MAVLink system ids that it may use; empty = any
    std::shared_ptr<const Key32> presharedKey = nullptr; ///< additional shared secret; null = all zero
};

/// Suites and framings that may be negotiated.
struct Policy
{
    /// In order of preference. Research suites are offered only with `allowResearch` and never chosen first.
    std::vector<crypto::SuiteId> suites;
    bool allowResearch = false;
    /// Consent to plain MAVLink as the baseline of a measurement; requires the consent of the other end as well.
    bool allowPlain = false;
    /// Consent to inline framing, with an 8-byte tag. It is used if both ends consent and at least one prefers it, under the
    /// suites that have it.
    bool allowInline = false;
    bool preferInline = false;

    bool operator==(const Policy &) const = default;
};

/// Framing of MAVLink frames: whole in sealed records, or each sealed in place with a clear header.
enum class Framing : std::uint8_t { Sealed, Inline };

/// All authenticated suites, the default first, research suites last (they also need `allowResearch`).
std::vector<crypto::SuiteId> defaultSuites();

} // namespace skyseal::channel
