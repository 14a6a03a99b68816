// Handshake patterns as the Noise specification writes them (revision 34, 7 and 18), with psk modifiers (9).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::noise {

enum class Token : std::uint8_t { E, S, EE, ES, SE, SS, Psk };

/// One side's public keys that the other knows beforehand, or the tokens of one message.
using MessagePattern = std::vector<Token>;

struct HandshakePattern
{
    std::string name; ///< with its modifiers: "IKpsk2"
    MessagePattern initiatorPreMessage;
    MessagePattern responderPreMessage;
    std::vector<MessagePattern> messages; ///< in turn, the initiator's first
    std::size_t pskCount = 0;

    bool usesPsk() const { return pskCount > 0; }
    /// "Noise_<name>_25519_ChaChaPoly_BLAKE2b"
    std::string protocolName() const;
};

/// Between peers that know each other's static key; a psk of zeros where they share none.
inline constexpr std::string_view kKnownPeers = "IKpsk2";
/// For pairing: static keys are exchanged, and confirmed by people.
inline constexpr std::string_view kPairing = "XXpsk3";

/// The pattern of that name, for instance "XX", "IKpsk2", "NNpsk0+psk2"; nullopt for one that is not in the specification.
std::optional<HandshakePattern> handshakePattern(std::string_view name);

} // namespace skyseal::noise
