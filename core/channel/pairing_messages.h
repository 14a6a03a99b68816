// The bytes of the pairing messages (PROTOCOL.md, section 13).
//
//   request   station -> agent   0x5C | zeros 126                                                            127 bytes
//   call      agent -> station   0x5C | token 16 | zeros 110                                                 127 bytes
//   first     station -> agent   0x5D | id 4 | token 16 | share 32 | zeros 74                                127 bytes
//   answer    agent -> station   0x5E | id 4 | share 32 | commitment 32                                       69 bytes
//   opening   both ways          0x5F | id 4 | 0 1 | sealed(key 32 | system 1 | name 24 | nonce 16) + 16      95 bytes
//   word      both ways          0x5F | id 4 | number 1 | tag 16                                              22 bytes
//
// The token belongs to the window: a sender that returns it has received a call. The number of a word, 0x80 | mine * 4 | heard,
// holds the decision at this end and the acknowledged one of the other end.
#pragma once

#include "core/channel/pairing_config.h"
#include "core/channel/policy.h"
#include "core/channel/wire_format.h"

#include <array>
#include <optional>

namespace skyseal::channel {

enum class PairingMessage : std::uint8_t { Call = 0, First = 1, Answer = 2, Sealed = 3 };
enum class PairingId : std::uint32_t {};

inline constexpr std::size_t kPairingLength = 127; ///< of request, call and first: no end sends more than it received
inline constexpr std::size_t kPairingAnswerLength = 69;
inline constexpr std::size_t kOpeningLength = 95;
inline constexpr std::size_t kWordLength = 22;
inline constexpr std::size_t kSealedHead = 6; ///< of openings and words; their associated data

using PairingToken = std::array<std::uint8_t, 16>;
using PairingDatagram = std::array<std::uint8_t, kPairingLength>;
using PairingAnswer = std::array<std::uint8_t, kPairingAnswerLength>;
using OpeningDatagram = std::array<std::uint8_t, kOpeningLength>;
using WordDatagram = std::array<std::uint8_t, kWordLength>;
using Commitment = std::array<std::uint8_t, 32>;
using PairingShare = std::array<std::uint8_t, 32>; ///< of CPace

constexpr std::uint8_t firstByte(PairingMessage message)
{
    return firstByte(DatagramKind::Pairing, static_cast<std::uint8_t>(message));
}

/// The claims of an end about itself. The agent commits to these bytes before it knows the station's.
struct PairingOpening
{
    static constexpr std::size_t kLength = 32 + 1 + kMaxPairingName + 16;
    using Bytes = std::array<std::uint8_t, kLength>;

    PublicKey key{};
    std::uint8_t systemId = 0;               ///< 0 = unknown
    std::string name;                        ///< at most 24 bytes on the wire; read with unfit characters replaced by "-"
    std::array<std::uint8_t, 16> nonce = {}; ///< random, secret until the opening

    Bytes write() const;
    static PairingOpening read(const Bytes &bytes);
};
/// Binds the agent to its opening, and hides it.
Commitment commitmentTo(const PairingOpening::Bytes &opening);

/// The six digits that people compare, "123 456". At each end, a man in the middle is bound to his nonce before he knows the
/// true one: two codes agree with a probability of 1 in 1,000,000.
std::string pairingCode(const PairingDatagram &first, const PairingAnswer &answer, const PairingOpening &station,
                        const PairingOpening &agent);

/// Decision of a person; Yes and No are final.
enum class Decision : std::uint8_t { None = 0, Yes = 1, No = 2 };

/// Acknowledgement of the other end's decision, and finally of its acknowledgement, so that both can stop.
enum class Heard : std::uint8_t { Nothing = 0, Yes = 1, No = 2, AllIsSaid = 3 };

struct Word
{
    Decision mine{};
    Heard heard{};

    std::uint8_t number() const;
    /// nullopt for a number that no word has.
    static std::optional<Word> fromNumber(std::uint8_t number);
};

/// A first message or an answer.
struct PairingHello
{
    PairingId id{};
    PairingShare share{};
    PairingToken token{};    ///< of a first message
    Commitment commitment{}; ///< of an answer
};

PairingDatagram pairingRequest();
PairingDatagram pairingCall(const PairingToken &token);
PairingDatagram pairingFirst(const PairingHello &hello);
PairingAnswer pairingAnswer(const PairingHello &hello);
std::array<std::uint8_t, kSealedHead> sealedHead(PairingId id, std::uint8_t number);

// Of messages whose length is right; nullopt for others.
bool isPairingRequest(ByteView datagram);
std::optional<PairingToken> calledToken(ByteView datagram);
std::optional<PairingHello> readFirst(ByteView datagram);
std::optional<PairingHello> readAnswer(ByteView datagram);

bool isOpening(ByteView datagram);
bool isWord(ByteView datagram);
/// Of an opening or a word.
PairingId sealedPairing(ByteView datagram);

} // namespace skyseal::channel
