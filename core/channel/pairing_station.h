// The station's part of a pairing handshake: it listens for calls and takes up one caller after the other.
#pragma once

#include "core/channel/token_bucket.h"
#include "core/channel/pairing_confirmation.h"

namespace skyseal::channel {

class PairingStation
{
public:
    explicit PairingStation(PairingCore &core) : m_core(core) {}

    void handleCall(TimePoint now, const Path &from, ByteView datagram);
    void handleAnswer(TimePoint now, const Path &from, ByteView datagram);
    /// The first word of an agent: it accepted our third message, so it knows the passphrase if there is one.
    std::optional<PairingConfirmation> handleWord(TimePoint now, const Path &from, ByteView datagram);
    /// The caller on this path was refused.
    void setAside(const Path &path);
    void handleDeadline(TimePoint now);
    TimePoint deadline() const;

private:
    struct Caller
    {
        Path path;
        PairingToken token{};
        TimePoint heard{};
        TimePoint tried = TimePoint::min();
        bool aside = false;
    };
    /// A handshake with one caller; after its answer the third message is repeated until a word comes.
    struct Attempt
    {
        PairingHandshake handshake;
        Path path;
        PairingDatagram first{};
        TimePoint until{};
        TimePoint sentAt{};
        std::optional<PairingVoice> voice = std::nullopt;
        PairingPeer peer = {};
        bool presharedKeyWanted = false;
        ThirdDatagram third{};
        TimePoint due = kNever;
        unsigned sent = 0;
    };

    void begin(TimePoint now);
    void sendThird(TimePoint now);

    PairingCore &m_core;
    std::vector<Caller> m_callers;
    std::optional<Attempt> m_attempt;
    TokenBucket m_answers;                   ///< answers that may be computed on
    TimePoint m_nextFrom = TimePoint::min(); ///< earliest time of the next attempt
};

} // namespace skyseal::channel
