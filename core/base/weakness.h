// Weaknesses that tests can put into the protocol on purpose, to prove that each attack test fails when its defense is
// missing. In shipped libraries weakened() is a constant false, and the call compiles to nothing. Only the test libraries
// that are built with SKYSEAL_WEAKEN use a real weakened(). It is defined in tests/weakened, so that a shipped program
// compiled with SKYSEAL_WEAKEN would not link.
#pragma once

#include <cstdint>

namespace skyseal {

enum class Weakness : std::uint8_t {
    // records
    NoTagCheck,         ///< a wrong tag is accepted
    NoEncryption,       ///< the suites leave the plaintext as it is
    SharedNonce,        ///< all records of an epoch use the nonce of the first
    NoAssociatedData,   ///< header, suite, direction and carrier are not authenticated
    NoDirections,       ///< both ends seal under the same keys
    SameKeysEveryEpoch, ///< a new epoch keeps the keys of the previous one
    PaddingAccepted,    ///< wrong padding is accepted
    NoReplayWindow,     ///< every counter counts as fresh
    NoCloneCheck,       ///< an end does not notice that the keys of one end are in use twice
    WindowBeforeTag,    ///< the window moves before the tag is verified
    RoamOnForged,       ///< a rejected record moves the session's address
    RoamOnLate,         ///< an authentic record moves the address even when it is not the newest
    NoTrial,         ///< the session's address stays where one record moved it, although nothing was received from there since
    ReturnToUnheard, ///< after a trial a session returns to the address of its first message, where its peer was never heard
    TrialByAnyEcho,  ///< the trial of an address ends by an echo of what was sent to another address
    TrialByRepeatedStamp, ///< the trial of an address ends by an echo that is older by 36 to 72 minutes
    NoHardStop,           ///< an epoch never ends
    KeepOldKeys,          ///< neither the previous epoch nor a session expires
    NoWipe,               ///< secrets stay in memory after their destruction
    NoMemoryLock,         ///< pages with keys may reach the swap space
    NoOvertakenLimit,     ///< a record commands, however long ago a newer one arrived
    NoFrameOrder,         ///< frames that arrive late set present values of the display
    NoAgeLimit,           ///< a record commands, however old it may be
    OldReports,           ///< a report counts although a newer one came before it
    LifeWithoutReports,   ///< any record keeps a session alive, not only echoes in reports
    CommandsAfterClose,   ///< a record commands although the peer has closed the session
    // switch
    NoSwitchExchange, ///< the keys of the next epoch follow from those of the present one
    CommitEarly,      ///< the responder sends under the next epoch as soon as it has accepted
    // handshake
    NoMac1,             ///< mac1 is not checked
    NoHandshakeTag,     ///< Noise payloads and static keys are not authenticated
    NoPrologue,         ///< version and carrier are not hashed
    NoEphemeralMix,     ///< the shared secret of the two ephemeral keys is left out
    AcceptLowerCounter, ///< a replayed first message is accepted
    NoConfirmation,     ///< a session is up before the station has proved its identity
    NoPinning,          ///< an unknown key is treated as the first known peer
    NoOfferRecheck,     ///< the station accepts any suite the agent chose
    NoRateLimit,        ///< unlimited Diffie-Hellman computations for unknown senders
    AnswerTwice,        ///< responses are larger than requests
    NoForm,             ///< announcements and cookies are hashed whatever their form
    NotifyEverything,   ///< every refused handshake is an event
    SharedNotices,      ///< unknown agents keep other refusals from the owner of a station
    TrustAnnouncements, ///< an announcement starts a handshake even while a session lives
    NoCookie,           ///< an agent under load computes without asking for a cookie
    HurryCalls,         ///< each change of the addresses of agents that listen begins a new turn of calls
    CallRouters,        ///< agents are called where MAVLink comes from as well
    RetryUnproven,      ///< a first message is repeated by timer to the unproven address of an announcement
    // pairing
    PairOnOneYes, ///< the other user's confirmation is enough
    NoPassphrase, ///< the passphrase is not mixed into the handshake
    NoCommitment, ///< an agent may show another opening than it committed to
    OpenAgain,    ///< an end shows an opening of another handshake after one was interrupted
    GuessAgain,   ///< the agent's window stays open, however often the passphrase was wrong
    ShowNewest,   ///< a new device replaces the one being compared
    // carriers
    LoosePart,       ///< parts of TUNNEL messages are joined across messages and senders
    NoScanLimit,     ///< bytes that are no frames may cost any work
    NoTunnelPadding, ///< messages in TUNNEL are taken although MAVLink left out the zeros that make them long
    // files
    NoFileCheck,      ///< owner and permissions of a file are not checked
    NoFileChecksum,   ///< a damaged key is accepted
    Leak,             ///< an error message quotes the unreadable line
    CountersOneByOne, ///< the counters of first messages are reserved and stored one by one
    StopWithoutDisk,  ///< a counter that cannot be stored is not accepted
    AnyName,          ///< names of peers may hold control and format characters
    NotifiedOnly,     ///< the list of peers is read only where the system notifies of its change
    // station and agent
    NoRoleCheck,        ///< observers may send commands
    Misreadable,        ///< messages of observers are forwarded although losing a part would change their meaning
    AnyStreamRate,      ///< observers may start streams of any rate
    UnlimitedQuestions, ///< observers may ask without end
    NoSenderCheck,      ///< a sealed peer may use any system id
    UnlimitedClaims,    ///< an agent may claim any number of system ids, for ever
    VehicleTakesAnyId,  ///< a heartbeat on the vehicle's side may take the system id of a ground station
    ClearAccepted,      ///< clear frames are accepted after a sealed session
    // evaluated only by the tests' own parts
    SameRandomEveryLife, ///< a restarted end gets the random bytes of the previous one
    Impatient,           ///< a session ends after ten seconds of silence
    CountersFromClock,   ///< the counter of first messages is the time of day
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
