// Which attack test fails, in which check, under which weakness of the protocol.
#pragma once

#include <QtCore/QStringList>

namespace skyseal::test {

struct Proof
{
    const char *weaknesses; ///< names of patches, joined by commas
    const char *test;
    const char *function;
    const char *check; ///< words of the check that must fail
    /// Rows of the function that this weakness leaves as they are, joined by semicolons; all others must fail. Each row
    /// fails in one proof at least.
    const char *untouched = "";
};

inline constexpr Proof kProofs[] = {
    {"NoEncryption", "attack_record_test", "eavesdropping", "the wire looks uniform"},
    {"SharedNonce", "attack_record_test", "keystreamReuse", "no keystream comes twice"},
    {"NoTagCheck,NoCloneCheck", "attack_record_test", "everyBitFlipped", "no changed bit is accepted"},
    {"NoTagCheck", "attack_record_test", "everyLength", "no other length is accepted", "aes-256-cbc"},
    {"NoTagCheck,PaddingAccepted", "attack_record_test", "everyLength", "no other length is accepted"},
    {"NoTagCheck", "attack_record_test", "splicedRecords", "no piece is accepted"},
    {"NoTagCheck", "attack_record_test", "fabricatedRecords", "nothing made up is accepted"},
    {"NoReplayWindow", "attack_record_test", "replayOfEverything", "nothing is accepted twice"},
    {"NoReplayWindow", "attack_record_test", "replayAtTheEdgeOfTheWindow", "nothing is accepted twice"},
    {"NoTagCheck", "attack_record_test", "acrossSuitesAndEpochs", "no record opens under another suite"},
    {"SameKeysEveryEpoch", "attack_record_test", "replayFourEpochsLater", "no record opens in a later epoch"},
    {"NoTagCheck", "attack_record_test", "acrossSessions", "no record opens in another session"},

    {"NoAssociatedData", "attack_key_test", "contextIsSealedIn", "header, suite, direction and carrier are sealed in"},
    {"NoDirections", "attack_key_test", "directionsHaveSeparateKeys", "what one end seals does not open as the other's"},
    {"PaddingAccepted", "attack_key_test", "badPaddingLooksLikeABadTag", "bad padding is refused as a bad tag is"},

    {"AcceptLowerCounter,NoConfirmation", "attack_session_test", "replayOfAnEarlierSession",
     "no old handshake makes a session"},
    {"NoCloneCheck", "attack_session_test", "clonedEnd", "keys that are in use twice end with their session"},
    {"NoCloneCheck", "attack_session_test", "restoredEnd", "a session that went on elsewhere ends"},
    {"NoReplayWindow", "attack_session_test", "replayOnAnotherLink", "nothing is delivered twice"},
    {"AcceptLowerCounter,NoConfirmation", "attack_session_test", "replayOnAnotherLink", "no old handshake makes a session"},
    {"NoDirections,NoCloneCheck", "attack_session_test", "reflection", "nothing is accepted by its own sender"},
    {"WindowBeforeTag", "attack_session_test", "windowPoisoning", "the stream goes on"},
    {"RoamOnForged", "attack_session_test", "hijackOfAnAddress", "no refused record moves the session"},
    {"RoamOnLate", "attack_session_test", "hijackOfAnAddress", "no late record moves the session"},
    {"RoamOnForged", "attack_session_test", "newPortResumesAtOnce", "the session "},
    {"NoTrial", "attack_session_test", "withheldRecordDivertsForSeconds", "the session goes back to its peer"},
    {"ReturnToUnheard", "attack_session_test", "repeatedFirstMessageDivertsNothing",
     "the address of a first message alone gets no records"},
    {"TrialByAnyEcho", "attack_session_test", "answersToOtherAddressesEndNoTrial", "the session goes back to its peer"},
    {"TrialByRepeatedStamp,LifeWithoutReports", "attack_session_test", "echoesOfAnHourAgoEndNoTrial",
     "the session goes back to its peer"},
    {"NoReplayWindow", "attack_session_test", "jitterReorderingAndDuplicates", "each frame arrives once"},
    {"WindowBeforeTag", "attack_session_test", "deletion", "lost is exactly what was dropped"},
    {"Impatient", "attack_session_test", "outageOfFiveMinutes", "the first record after it is accepted"},
    {"Impatient", "attack_session_test", "jammedThenLossyLink", "the first record after it is accepted"},
    {"CountersFromClock", "attack_session_test", "clockSteps", "a handshake needs no clock"},
    {"TrustAnnouncements", "attack_session_test", "replayedAnnouncementsEndNothing",
     "no handshake is begun while the session lives"},
    {"OldReports", "attack_session_test", "withheldReportOfADeafAgent", "no old report begins a handshake on another carrier"},
    {"SameRandomEveryLife,CountersFromClock,AcceptLowerCounter", "attack_session_test", "killedTwoHundredTimes",
     "no pair of key and nonce comes twice"},
    {"NoHardStop", "attack_session_test", "everyControlRecordDropped", "an epoch ends at its limit"},

    {"NoOvertakenLimit", "attack_freshness_test", "withheldCommand", "no overtaken command is obeyed"},
    {"NoOvertakenLimit", "attack_freshness_test", "withheldBurst", "no overtaken command is obeyed"},
    {"LifeWithoutReports", "attack_freshness_test", "withheldReports", "a session without reports ends"},
    {"LifeWithoutReports", "attack_freshness_test", "bothEndsAsleep", "a session that is over takes nothing"},
    {"CommandsAfterClose", "attack_freshness_test", "releasedAfterClose", "nothing commands after the close"},
    {"NoAgeLimit", "attack_freshness_test", "releasedAfterAWithheldClose", "nothing older than the limit is obeyed"},
    {"NoAgeLimit,LifeWithoutReports", "attack_freshness_test", "releasedWhenTheStampsRepeat",
     "nothing older than the limit is obeyed"},
    {"NoOvertakenLimit", "attack_freshness_test", "releasedAfterASwitch", "no overtaken command is obeyed"},
    {"NoAgeLimit", "attack_freshness_test", "wholeFlowHeldThenReleased", "nothing older than the limit is obeyed"},
    {"NoAgeLimit", "attack_freshness_test", "wholeFlowDelayed", "nothing older than the limit is obeyed"},
    {"NoAgeLimit", "attack_freshness_test", "onlyTheWayBackDelayed", "nothing that may be older than the limit is obeyed"},
    {"NoAgeLimit", "attack_freshness_test", "growingDelay", "nothing older than the limit is obeyed"},
    {"NoAgeLimit", "attack_freshness_test", "limitIsConfigurable", "nothing older than the limit is obeyed"},
    {"NoAgeLimit", "attack_freshness_test", "otherStationsKeepNothingFresh", "nothing older than the limit is obeyed"},
    {"NoOvertakenLimit", "attack_freshness_test", "staleTelemetry", "no overtaken telemetry sets a present value"},

    {"NoTagCheck", "attack_flood_test", "injectedGarbage", "no garbage is accepted"},
    {"NoTagCheck", "attack_flood_test", "oversizedDatagrams", "no oversized datagram is accepted"},
    {"NoTagCheck", "attack_flood_test", "forgeriesInAFlood", "each forgery is counted"},
    {"NoMac1", "attack_flood_test", "handshakeFlood", "a station that calls gets its session"},
    {"NoRateLimit", "attack_flood_test", "handshakeFloodWithTheRightMac", "at most fifty computations a second"},
    {"NoRateLimit", "attack_flood_test", "answerFloodWithTheRightMac", "at most fifty computations a second"},
    {"NoRateLimit", "attack_flood_test", "numberFloodWithTheRightMac", "a few false numbers are computed on"},
    {"NoForm", "attack_stranger_test", "malformedMessagesCostNoHash", "a datagram without the form costs no hash"},
    {"NoRateLimit", "attack_stranger_test", "announcementsForManyPeers", "a message of a stranger costs two hashes"},
    {"NoRateLimit", "attack_stranger_test", "cookiesForManyAttempts", "a message of a stranger costs two hashes"},
    {"NotifyEverything", "attack_stranger_test", "floodRaisesOneEventASecond",
     "strangers cause one event a second of each reason"},
    {"SharedNotices", "attack_stranger_test", "unknownAgentsHideNoRefusal", "a station reports its own refusals"},
    {"NotifyEverything", "attack_flood_test", "floodRaisesFewEvents", "a flood from everywhere causes few notices"},
    {"AnswerTwice", "attack_flood_test", "noMoreOutThanIn", "no more goes out than came in"},
    {"AnswerTwice", "attack_flood_test", "noMoreOutThanInDuringASession", "no more goes out than came in"},

    {"NoPinning", "attack_handshake_test", "interception", "an unknown key gets no answer"},
    {"NoHandshakeTag,NoPinning", "attack_handshake_test", "unknownKeyShare", "a message for another agent gets no answer"},
    {"NoConfirmation", "attack_handshake_test", "keyCompromiseImpersonation", "no session comes of it, and none ends"},
    {"NoEphemeralMix", "attack_handshake_test", "revealedKeysOpenNothing", "the static keys open no record"},
    {"AcceptLowerCounter", "attack_handshake_test", "replayedFirstMessage", "an old first message gets no answer"},
    {"NoHandshakeTag", "attack_handshake_test", "everyBitOfTheFirstMessage", "no changed first message is read"},
    {"NoHandshakeTag", "attack_handshake_test", "everyBitOfTheAnswer", "no changed answer is taken"},
    {"NoOfferRecheck", "attack_handshake_test", "suiteOutsideTheOffers", "no other choice is taken"},
    {"NoPrologue", "attack_handshake_test", "otherVersionOrCarrier", "no message of another version or carrier is read"},

    {"NoTagCheck", "attack_inline_test", "everyBitOfAFrame", "no changed bit of a frame is accepted"},
    {"NoTagCheck", "attack_inline_test", "everyLengthOfAFrame", "no other length of a frame is accepted"},
    {"NoReplayWindow", "attack_inline_test", "replayOfFrames", "no frame is accepted twice, nor by its sender"},

    {"NoWipe", "attack_memory_test", "searchFindsAPlantedCopy", "a secret that died is gone"},
    {"NoWipe", "attack_memory_test", "deadSecretsAreGone", "the handshake's secrets are gone"},
    {"NoMemoryLock", "attack_memory_test", "livingSecretsAreLocked", "keys in use lie in locked pages"},
    {"KeepOldKeys", "attack_memory_test", "deadSecretsAreGone", "the keys of a dead epoch are gone"},
    {"NoWipe", "attack_memory_test", "switchSecretsAreGone", "the secrets of a switch are gone"},
    {"NoSwitchExchange", "attack_memory_test", "stolenChainOpensNoLaterEpoch", "a stolen chain opens no later epoch"},

    {"NotifyEverything", "attack_flight_test", "strangersCauseOneEventASecond", "strangers cause one event a second"},
    {"ClearAccepted", "attack_flight_test", "injectionReachesNoAutopilot", "the autopilot's state never changes"},
    {"NoRoleCheck", "attack_flight_test", "observerCommandsNothing", "an observer moves nothing"},
    {"Misreadable,UnlimitedQuestions", "attack_observer_test", "nothingIsNestedInAQuestion",
     "nothing else is found in what it said"},
    {"AnyStreamRate", "attack_observer_test", "streamRates", "no stream is stopped or fills the line"},
    {"UnlimitedQuestions", "attack_observer_test", "thousandQuestions", "an observer's questions are limited"},
    {"NoSenderCheck", "attack_flight_test", "nobodySpeaksAsAnother", "nothing of it reaches the autopilot"},
    {"UnlimitedClaims", "attack_systems_test", "oneAgentClaimsEverySystem", "an honest agent is not locked out"},
    {"UnlimitedClaims", "attack_systems_test", "claimEnds", "an honest agent is not locked out"},
    {"VehicleTakesAnyId", "attack_flight_test", "pilotsIdIsNotTaken", "the pilot is not locked out"},
    {"ClearAccepted", "attack_flight_test", "spoofedTelemetryIsNotShown", "the list of vehicles is unchanged"},
    {"ClearAccepted", "attack_flight_test", "blockedHandshakesOpenNoClearWay", "no telemetry without an explicit act"},
    {"NoEncryption", "attack_flight_test", "nothingReadableOnTheWire", "nothing that is known is found on the wire"},

    {"NoTagCheck", "attack_gateway_test", "attackIsCountedAndTheClientNoticesNothing",
     "each forged and each replayed record is refused and counted"},
    {"NoReplayWindow", "attack_gateway_test", "attackIsCountedAndTheClientNoticesNothing",
     "each forged and each replayed record is refused and counted"},

    {"NoEncryption", "attack_router_test", "copiesAreSealed", "he gets nothing but what is sealed"},
    {"ClearAccepted", "attack_flight_test", "clearBytesAreNotSearched", "clear bytes are counted and not searched"},

    {"ClearAccepted", "attack_router_test", "spoofedHeartbeatsAreNotTaken", "the vehicle is shown as it is"},
    {"RoamOnForged", "attack_router_test", "forgedTunnelsDivertNothing", "delivery goes on"},
    {"BelieveAnyCobs", "attack_router_test", "fakedCobsSilencesNothing", "every message in TUNNEL is read"},

    {"NoCookie", "attack_cookie_test", "floodFromForgedAddresses", "a station gets its session"},
    {"NoCookie", "attack_cookie_test", "floodFromRealAddresses", "a station gets its session"},
    {"NoCookie", "attack_cookie_test", "floodFromRealAddressesOfAStranger", "a station gets its session"},
    {"RetryUnproven", "attack_cookie_test", "replayedAnnouncementsDoNotAmplify", "no more goes out than came in"},
    {"RetryUnproven", "attack_cookie_test", "forgedCookiesDoNotAmplify", "no more goes out than came in"},

    {"PairOnOneYes", "attack_pairing_test", "inBetween", "nothing is kept without both yeses"},
    {"PairOnOneYes", "attack_pairing_test", "oneYesIsNotEnough", "nothing is kept without both yeses"},
    {"NoPassphrase", "attack_pairing_test", "inBetweenWithoutThePassphrase", "nobody is shown without the passphrase"},
    {"NoPassphrase", "attack_pairing_test", "passphraseMustBeTheSame", "nobody is shown without the passphrase"},
    {"ShowNewest", "attack_pairing_test", "anotherWhileComparing", "who came first stays"},
    {"NoCommitment", "attack_pairing_test", "nonceChosenAfterTheOthers", "an agent shows what it committed to"},
    {"OpenAgain", "attack_pairing_test", "oneOpeningOfTheStation", "one opening in a window"},
    {"OpenAgain", "attack_pairing_test", "oneOpeningOfTheAgent", "one opening in a window"},
    {"GuessAgain", "attack_pairing_test", "passphraseGuessedAtTheAgent", "three guesses in a window"},
    {"GuessAgain", "attack_pairing_test", "guessWithAnUnusableKeyCounts", "three guesses in a window"},
    {"OpenAgain", "attack_pairing_test", "passphraseGuessedAfterTheOpening", "a right guess looks like a wrong one"},

    {"LoosePart", "attack_parts_test", "splicedTunnelParts", "no message is put together of two"},
    {"LoosePart", "attack_parts_test", "partsOfSendersAreNotMixed", "no message is put together of two senders'"},

    {"KeepOldKeys", "attack_resources_test", "records", "memory is what it was"},
    {"KeepOldKeys", "attack_resources_test", "handshakes", "memory is what it was"},

    {"NoFileCheck", "attack_files_test", "keysThatOthersCanRead", "no key is used that others can read"},
    {"NoFileCheck", "attack_files_test", "peersThatOthersCanChange", "no list is used that others can change"},
    {"NoFileCheck", "attack_files_test", "symbolicLinks", "no secret is read through a link"},
    {"NoFileChecksum", "attack_files_test", "everyTruncation", "no piece of a key is a key"},
    {"NoFileChecksum", "attack_files_test", "everyDamagedCharacter", "no damaged key is a key"},
    {"NoFileChecksum", "attack_files_test", "everyDamagedPeer", "no damaged list is a list"},
    {"NoFileChecksum", "attack_files_test", "anotherPassphrase", "no key opens under another passphrase"},
    {"Leak", "attack_files_test", "errorsShowNoKey", "no error shows a key"},
    {"CountersOneByOne", "attack_files_test", "strangersCauseNoWrites", "strangers cause no writes to the disk"},
    {"StopWithoutDisk", "attack_files_test", "failingDiskEndsNoSession", "a failing disk ends no session"},
    {"AnyName", "attack_files_test", "namesThatSteerATerminal", "no name steers a terminal"},
    {"NotifiedOnly", "attack_revocation_test", "removedWithoutNotification", "a removed peer loses its session"},

    {"CommitEarly", "attack_switch_test", "raceOfBothEnds", "a switch loses nothing and repeats nothing"},
    {"CommitEarly", "attack_switch_test", "acceptancesAreDropped", "a switch loses nothing and repeats nothing"},
    {"NoRateLimit", "attack_switch_test", "proposalFlood", "at most fifty proposals a second are computed on"},
};

inline QStringList provenTests()
{
    QStringList out;
    for (const Proof &proof : kProofs)
        out << QLatin1String(proof.test);
    out.removeDuplicates();
    return out;
}

} // namespace skyseal::test
