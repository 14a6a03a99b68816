// Handshake patterns as the Noise specification writes them (revision 34, 7 and 18), with psk modifiers (9).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::noise {

enum class Token : std::uint8_t { E, S, EE, ES, SE, SS, Psk };

/// The tokens of one message, or of a pre-message: the public keys of one side that the other side knows in advance.
using MessagePattern = std::vector<Token>;

struct HandshakePattern
{
    std::string name; ///< with its modifiers: "IKpsk2"
    MessagePattern initiatorPreMessage;
    MessagePattern responderPreMessage;
    std::vector<MessagePattern> messages; ///< alternating, the initiator's first
    std::size_t pskCount = 0;

    bool usesPsk() const { return pskCount > 0; }
    /// "Noise_<name>_25519_ChaChaPoly_BLAKE2b"
    std::string protocolName() const;
};

/// Between peers that know each other's static key; the psk is zero if they share none.
inline constexpr std::string_view kKnownPeers = "IKpsk2";

/// A pattern by its name, for instance "XX", "IKpsk2", "NNpsk0+psk2"; nullopt if the specification does not define it.
std::optional<HandshakePattern> handshakePattern(std::string_view name);

} // namespace skyseal::noise
