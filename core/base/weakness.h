// Weaknesses that the tests can put into the protocol on purpose, so that each test of an attack is seen to fail where its
// defence is missing. In every library that is shipped weakened() is a constant false and its call compiles to nothing.
// Only the test library that is built with SKYSEAL_WEAKEN has another one: it is defined beside the tests, so that a
// shipped program with that definition would not even link.
#pragma once

#include <cstdint>

namespace skyseal {

enum class Weakness : std::uint8_t {
    // records
    NoTagCheck,         ///< a wrong tag is taken for a right one
    NoEncryption,       ///< the suites with HMAC leave the plaintext as it is
    SharedNonce,        ///< all records of an epoch use the nonce of the first
    NoAssociatedData,   ///< header, suite, direction and carrier are not authenticated
    NoDirections,       ///< both ends seal under the same keys
    SameKeysEveryEpoch, ///< a new epoch keeps the keys of the last
    PaddingAccepted,    ///< wrong padding is taken for right
    NoReplayWindow,     ///< every counter is fresh
    WindowBeforeTag,    ///< the window moves before the tag is verified
    RoamOnForged,       ///< a record that was refused moves the session's address
    RoamOnLate,         ///< an authentic record moves it even when it is not the newest
    NoTrial,            ///< the session's address stays where one record moved it, though nobody was heard there since
    NoHardStop,         ///< an epoch has no end
    KeepOldKeys,        ///< the previous epoch never dies by itself, and no session does
    NoWipe,             ///< secrets stay in memory when they die
    // switch
    CommitEarly, ///< the answerer sends under the next epoch as soon as it has accepted
    // handshake
    NoMac1,             ///< every handshake message seems to be meant for us
    NoHandshakeTag,     ///< Noise payloads and static keys are not authenticated
    NoPrologue,         ///< version and carrier are not hashed
    NoEphemeralMix,     ///< the shared secret of the two ephemeral keys is left out
    AcceptLowerCounter, ///< an old first message is as good as a new one
    NoConfirmation,     ///< a session is up before the station has proved itself
    NoPinning,          ///< an unknown key passes for the first known peer
    NoOfferRecheck,     ///< the station takes whatever suite the agent chose
    NoRateLimit,        ///< any number of Diffie-Hellman computations for strangers
    AnswerTwice,        ///< more goes out than came in
    TellEverything,     ///< each refused handshake is an event
    TrustAnnouncements, ///< an announcement starts a handshake even while a session lives
    NoCookie,           ///< an agent under load computes for whoever comes first
    RetryUnproven,      ///< a first message is repeated by timer to wherever an announcement claimed to come from
    // pairing
    PairOnOneYes, ///< the other person's yes is enough
    NoPassphrase, ///< a passphrase is not mixed into the handshake
    ShowNewest,   ///< another device takes the place of the one that is compared
    // carriers
    LoosePart, ///< parts of TUNNEL messages are put together whatever message and sender they are of
    // files
    NoFileCheck,    ///< who may read or change a file is not looked at
    NoFileChecksum, ///< a damaged key is taken for a good one
    Leak,           ///< an error quotes the line that cannot be read
    // the owners of the channel
    NoRoleCheck,   ///< observers may command
    Misreadable,   ///< what observers say may be something else when part of it is lost
    NoSenderCheck, ///< a sealed peer may speak as any system
    ClearAccepted, ///< clear frames are taken as if nothing had ever been sealed
    // what only the tests' own parts look at
    SameRandomEveryLife, ///< an end that starts anew gets the random bytes of the one before it
    Impatient,           ///< a session ends after ten seconds of silence
    CountersFromClock,   ///< the numbers in first messages are the time of day
};

#ifdef SKYSEAL_WEAKEN
bool weakened(Weakness);
#else
constexpr bool weakened(Weakness)
{
    return false;
}
#endif

} // namespace skyseal
