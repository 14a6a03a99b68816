// Which attack test fails, in which check, under which weakness of the protocol.
#pragma once

#include <QtCore/QStringList>

namespace skyseal::test {

struct Proof
{
    const char *weaknesses; ///< names of core/base/weakness.h, joined by commas
    const char *program;
    const char *function;
    const char *check; ///< words of the check that must fail
    /// Rows of the function that this weakness leaves as they are, joined by semicolons; all others must fail. Each row
    /// fails in one proof at least.
    const char *untouched = "";
};

inline constexpr Proof kProofs[] = {
    {"NoEncryption", "channel_attack_record_test", "eavesdropping", "the wire looks uniform"},
    {"SharedNonce", "channel_attack_record_test", "keystreamReuse", "no keystream comes twice"},
    {"NoTagCheck", "channel_attack_record_test", "everyBitFlipped", "no changed bit is accepted"},
    {"NoTagCheck", "channel_attack_record_test", "everyLength", "no other length is accepted", "aes-256-cbc"},
    {"NoTagCheck,PaddingAccepted", "channel_attack_record_test", "everyLength", "no other length is accepted"},
    {"NoTagCheck", "channel_attack_record_test", "splicedRecords", "no piece is accepted"},
    {"NoTagCheck", "channel_attack_record_test", "fabricatedRecords", "nothing made up is accepted"},
    {"NoReplayWindow", "channel_attack_record_test", "replayOfEverything", "nothing is accepted twice"},
    {"NoReplayWindow", "channel_attack_record_test", "replayAtTheEdgeOfTheWindow", "nothing is accepted twice"},
    {"NoTagCheck", "channel_attack_record_test", "acrossSuitesAndEpochs", "no record opens under another suite"},
    {"SameKeysEveryEpoch", "channel_attack_record_test", "replayFourEpochsLater", "no record opens in a later epoch"},
    {"NoTagCheck", "channel_attack_record_test", "acrossSessions", "no record opens in another session"},

    {"NoAssociatedData", "channel_attack_key_test", "contextIsSealedIn", "header, suite, direction and carrier are sealed in"},
    {"NoDirections", "channel_attack_key_test", "directionsHaveTheirOwnKeys",
     "what one end seals does not open as the other's"},
    {"PaddingAccepted", "channel_attack_key_test", "badPaddingLooksLikeABadTag", "bad padding is refused as a bad tag is"},

    {"AcceptLowerCounter,NoConfirmation", "channel_attack_session_test", "replayOfAnEarlierSession",
     "no old handshake makes a session"},
    {"NoReplayWindow", "channel_attack_session_test", "replayOnAnotherLink", "nothing is delivered twice"},
    {"AcceptLowerCounter,NoConfirmation", "channel_attack_session_test", "replayOnAnotherLink",
     "no old handshake makes a session"},
    {"NoDirections", "channel_attack_session_test", "reflection", "nothing is accepted by its own sender"},
    {"WindowBeforeTag", "channel_attack_session_test", "windowPoisoning", "the stream goes on"},
    {"RoamOnForged", "channel_attack_session_test", "hijackOfAnAddress", "no refused record moves the session"},
    {"RoamOnLate", "channel_attack_session_test", "hijackOfAnAddress", "no late record moves the session"},
    {"RoamOnForged", "channel_attack_session_test", "newPortResumesAtOnce", "the session "},
    {"NoTrial", "channel_attack_session_test", "keptRecordDivertsForMoments", "the session goes back to its peer"},
    {"NoReplayWindow", "channel_attack_session_test", "storm", "each frame arrives once"},
    {"WindowBeforeTag", "channel_attack_session_test", "deletion", "lost is exactly what was dropped"},
    {"Impatient", "channel_attack_session_test", "outageOfFiveMinutes", "the first record after it is accepted"},
    {"Impatient", "channel_attack_session_test", "jammedThenBad", "the first record after it is accepted"},
    {"CountersFromClock", "channel_attack_session_test", "clocksJump", "a handshake needs no clock"},
    {"TrustAnnouncements", "channel_attack_session_test", "replayedAnnouncementsEndNothing",
     "no handshake is begun while the session lives"},
    {"SameRandomEveryLife,CountersFromClock,AcceptLowerCounter", "channel_attack_session_test", "killedTwoHundredTimes",
     "no pair of key and nonce comes twice"},
    {"NoHardStop", "channel_attack_session_test", "everyControlRecordDropped", "an epoch ends at its limit"},

    {"NoTagCheck", "channel_attack_flood_test", "injectedGarbage", "no garbage is accepted"},
    {"NoTagCheck", "channel_attack_flood_test", "oversizedDatagrams", "no oversized datagram is accepted"},
    {"NoTagCheck", "channel_attack_flood_test", "forgeriesInAFlood", "each forgery is counted"},
    {"NoMac1", "channel_attack_flood_test", "handshakeFlood", "a station that calls gets its session"},
    {"NoRateLimit", "channel_attack_flood_test", "handshakeFloodWithTheRightMac", "at most fifty computations a second"},
    {"NoRateLimit", "channel_attack_flood_test", "answerFloodWithTheRightMac", "at most fifty computations a second"},
    {"NoRateLimit", "channel_attack_flood_test", "numberFloodWithTheRightMac", "a few false numbers are computed on"},
    {"TellEverything", "channel_attack_flood_test", "floodIsToldInFewWords", "a flood from everywhere is told in few words"},
    {"AnswerTwice", "channel_attack_flood_test", "noMoreOutThanIn", "no more goes out than came in"},
    {"AnswerTwice", "channel_attack_flood_test", "noMoreOutThanInBesideASession", "no more goes out than came in"},

    {"NoPinning", "channel_attack_handshake_test", "interception", "an unknown key gets no answer"},
    {"NoHandshakeTag,NoPinning", "channel_attack_handshake_test", "unknownKeyShare",
     "a message for another agent gets no answer"},
    {"NoConfirmation", "channel_attack_handshake_test", "keyCompromiseImpersonation", "no session comes of it, and none ends"},
    {"NoEphemeralMix", "channel_attack_handshake_test", "revealedKeysOpenNothing", "the static keys open no record"},
    {"AcceptLowerCounter", "channel_attack_handshake_test", "replayedFirstMessage", "an old first message gets no answer"},
    {"NoHandshakeTag", "channel_attack_handshake_test", "everyBitOfTheFirst", "no changed first message is read"},
    {"NoHandshakeTag", "channel_attack_handshake_test", "everyBitOfTheAnswer", "no changed answer is taken"},
    {"NoOfferRecheck", "channel_attack_handshake_test", "weakerChoice", "no other choice is taken"},
    {"NoPrologue", "channel_attack_handshake_test", "otherVersionOrCarrier",
     "no message of another version or carrier is read"},

    {"NoTagCheck", "channel_attack_inline_test", "everyBitOfAFrame", "no changed bit of a frame is accepted"},
    {"NoTagCheck", "channel_attack_inline_test", "everyLengthOfAFrame", "no other length of a frame is accepted"},
    {"NoReplayWindow", "channel_attack_inline_test", "replayOfFrames", "no frame is accepted twice, nor by its sender"},

    {"NoWipe", "channel_attack_memory_test", "searchFindsAPlantedCopy", "a secret that died is gone"},
    {"NoWipe", "channel_attack_memory_test", "deadSecretsAreGone", "the handshake's secrets are gone"},
    {"KeepOldKeys", "channel_attack_memory_test", "deadSecretsAreGone", "the keys of a dead epoch are gone"},

    {"ClearAccepted", "attack_flight_test", "injectionReachesNoAutopilot", "the autopilot's state never changes"},
    {"NoRoleCheck", "attack_flight_test", "observerCommandsNothing", "an observer moves nothing"},
    {"Misreadable", "attack_observer_test", "nothingIsNestedInAQuestion", "nothing else is found in what it said"},
    {"NoSenderCheck", "attack_flight_test", "nobodySpeaksAsAnother", "nothing of it reaches the autopilot"},
    {"ClearAccepted", "attack_flight_test", "spoofedTelemetryIsNotShown", "the list of vehicles is unchanged"},
    {"ClearAccepted", "attack_flight_test", "blockedHandshakesOpenNoClearWay", "no telemetry without an explicit act"},
    {"NoEncryption", "attack_flight_test", "nothingReadableOnTheWire", "nothing that is known is found on the wire"},

    {"NoEncryption", "attack_router_test", "copiesAreSealed", "he gets nothing but what is sealed"},
    {"ClearAccepted", "attack_router_test", "spoofedHeartbeatsAreNotTaken", "the vehicle is shown as it is"},
    {"RoamOnForged", "attack_router_test", "forgedTunnelsDivertNothing", "delivery goes on"},

    {"NoCookie", "channel_attack_cookie_test", "floodFromForgedAddresses", "a station gets its session"},
    {"NoCookie", "channel_attack_cookie_test", "floodFromRealAddresses", "a station gets its session"},
    {"NoCookie", "channel_attack_cookie_test", "floodFromRealAddressesOfAStranger", "a station gets its session"},
    {"RetryUnproven", "channel_attack_cookie_test", "announcementsAreNoAmplifier", "no more goes out than came in"},
    {"RetryUnproven", "channel_attack_cookie_test", "forgedCookiesAreNoAmplifier", "no more goes out than came in"},

    {"PairOnOneYes", "channel_attack_pairing_test", "inBetween", "nothing is kept without both yeses"},
    {"PairOnOneYes", "channel_attack_pairing_test", "oneYesIsNotEnough", "nothing is kept without both yeses"},
    {"NoPassphrase", "channel_attack_pairing_test", "inBetweenWithoutThePassphrase", "nobody is shown without the passphrase"},
    {"NoPassphrase", "channel_attack_pairing_test", "passphraseMustBeTheSame", "nobody is shown without the passphrase"},
    {"ShowNewest", "channel_attack_pairing_test", "anotherWhileComparing", "who came first stays"},

    {"LoosePart", "channel_attack_parts_test", "splicedParts", "no message is put together of two"},
    {"LoosePart", "channel_attack_parts_test", "sendersDoNotMix", "no message is put together of two senders'"},

    {"KeepOldKeys", "channel_attack_resources_test", "records", "memory is what it was"},
    {"KeepOldKeys", "channel_attack_resources_test", "handshakes", "memory is what it was"},

    {"NoFileCheck", "attack_files_test", "keysThatOthersCanRead", "no key is used that others can read"},
    {"NoFileCheck", "attack_files_test", "peersThatOthersCanChange", "no list is used that others can change"},
    {"NoFileCheck", "attack_files_test", "symbolicLinks", "no secret is read through a link"},
    {"NoFileChecksum", "attack_files_test", "everyTruncation", "no piece of a key is a key"},
    {"NoFileChecksum", "attack_files_test", "everyDamagedCharacter", "no damaged key is a key"},
    {"NoFileChecksum", "attack_files_test", "everyDamagedPeer", "no damaged list is a list"},
    {"NoFileChecksum", "attack_files_test", "anotherPassphrase", "no key opens under another passphrase"},
    {"Leak", "attack_files_test", "errorsShowNoKey", "no error shows a key"},

    {"CommitEarly", "channel_attack_switch_test", "raceOfBothEnds", "a switch loses nothing and repeats nothing"},
    {"CommitEarly", "channel_attack_switch_test", "acceptancesAreDropped", "a switch loses nothing and repeats nothing"},
};

inline QStringList provenPrograms()
{
    QStringList out;
    for (const Proof &proof : kProofs)
        out << QLatin1String(proof.program);
    out.removeDuplicates();
    return out;
}

} // namespace skyseal::test
