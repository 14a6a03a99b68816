// The reasons for which requests to a vehicle fail, or for which nothing is sent.
#pragma once

#include "core/base/reason.h"

namespace skyseal::vehicle {

namespace reasons {

// Of all requests.
inline constexpr Sentence kNothingSent = sentence("Reason", "nothing was sent: %1");
inline constexpr Sentence kNotSupported = sentence("Reason", "not supported");
inline constexpr Sentence kNoVehicle = sentence("Reason", "no vehicle with system ID %1");
inline constexpr Sentence kNoAnswer = sentence("Reason", "no answer to %1 attempts");
inline constexpr Sentence kOtherAutopilot = sentence("Reason",
                                                     "another component turned out to be the autopilot; request it again");
inline constexpr Sentence kPlanNeedsVersion2 = sentence(
    "Reason", "the vehicle speaks MAVLink 1, which knows missions only; fences and rally points need MAVLink 2");
inline constexpr Sentence kCancelled = sentence("Reason", "cancelled");
/// Only the agent's list contains the role of this station, and an agent answers neither an observer's commands nor late ones.
inline constexpr Sentence kMaybeDropped = sentence(
    "Reason", "%1; the agent may know this station as an observer, or the commands reach it too late: it drops both");
/// A reason, and what else is known: the vehicle's own texts, or an item of a list.
inline constexpr Sentence kWithTexts = sentence("Reason", "%1: %2");

// Of commands.
inline constexpr Sentence kSuspended = sentence("Reason",
                                                "no answer yet, and not sent again: this program was suspended for %1 s");
inline constexpr Sentence kTooManyCommands = sentence("Reason", "too many commands are waiting for answers");
inline constexpr Sentence kReplaced = sentence("Reason", "replaced by a newer command");
inline constexpr Sentence kNotConfirmed = sentence("Reason", "sent %1 times; the vehicle does not confirm it");
inline constexpr Sentence kNoHeartbeat = sentence("Reason", "acknowledged; no heartbeat since");
inline constexpr Sentence kStillArmed = sentence("Reason", "acknowledged, but the vehicle reports armed");
inline constexpr Sentence kStillDisarmed = sentence("Reason", "acknowledged, but the vehicle reports disarmed");
inline constexpr Sentence kLeftForMode = sentence("Reason", "it needs the mode %1, the vehicle went to %2");
inline constexpr Sentence kStaysInMode = sentence("Reason", "it needs the mode %1, the vehicle stays in %2");
inline constexpr Sentence kOtherMode = sentence("Reason", "acknowledged, but the vehicle reports the mode %1");
inline constexpr Sentence kNotReady = sentence("Reason", "the vehicle was not ready for it, and is in %1 now");
/// A command of several steps failed at its first ones, or at its last one.
inline constexpr Sentence kFailedInMode = sentence("Reason", "the mode %1 was not entered: %2");
inline constexpr Sentence kFailedToArm = sentence("Reason", "the vehicle was not armed: %1");
inline constexpr Sentence kFailedArmed = sentence("Reason", "%1; the vehicle is armed");
inline constexpr Sentence kOtherItem = sentence("Reason", "acknowledged, but the vehicle reports mission item %1");

// Why a command cannot be made for this vehicle in this state.
inline constexpr Sentence kModesUnknown = sentence("Reason", "the modes of this kind of vehicle are not known");
inline constexpr Sentence kNoSuchMode = sentence("Reason", "the vehicle has no mode '%1'; it has %2");
inline constexpr Sentence kTakeOffTooLow = sentence("Reason", "the altitude of a take-off must be above 0 m");
inline constexpr Sentence kDoesNotFly = sentence("Reason", "this kind of vehicle does not fly");
inline constexpr Sentence kTakeOffNeedsGuided = sentence("Reason", "take-off needs the mode GUIDED, the vehicle is in %1");
inline constexpr Sentence kTakeOffNeedsArmed = sentence("Reason", "take-off needs an armed vehicle, it is disarmed");
inline constexpr Sentence kStartNeedsArmed = sentence("Reason", "a mission needs an armed vehicle to start, it is disarmed");
inline constexpr Sentence kNoVerticalTakeOff = sentence(
    "Reason", "a plane without vertical take-off takes off in the mode TAKEOFF, or in a mission");
inline constexpr Sentence kDisarmInAir = sentence("Reason",
                                                  "the vehicle is in the air; only an emergency stop ends its motors");
inline constexpr Sentence kTakeOffNeedsPosition = sentence("Reason", "take-off needs a known position");
inline constexpr Sentence kNoModeToLand = sentence("Reason", "this kind of vehicle has no mode to land in");
inline constexpr Sentence kNoVerticalLanding = sentence("Reason",
                                                        "a plane without vertical take-off lands in a mission, or by hand");
inline constexpr Sentence kNoMission = sentence("Reason", "this kind of vehicle flies no missions");
inline constexpr Sentence kNoModeToReturn = sentence("Reason", "this kind of vehicle has no mode to return in");
inline constexpr Sentence kNoModeToLoiter = sentence("Reason", "this kind of vehicle has no mode to loiter in");
inline constexpr Sentence kNotOnGlobe = sentence("Reason", "the location is not on the globe");
inline constexpr Sentence kGoToNeedsGuided = sentence("Reason",
                                                      "going to a location needs the mode GUIDED, the vehicle is in %1");
inline constexpr Sentence kGoToNeedsHome = sentence("Reason", "going to a location needs a known home altitude");
inline constexpr Sentence kAltitudeNoNumber = sentence("Reason", "the altitude is not a number");
inline constexpr Sentence kAltitudeNeedsPosition = sentence("Reason", "changing the altitude needs a known position");
inline constexpr Sentence kAltitudeNeedsHome = sentence("Reason", "changing the altitude needs a known home altitude");
inline constexpr Sentence kPointNeedsHome = sentence("Reason", "pointing at a location needs a known home altitude");
inline constexpr Sentence kHomeNeedsHome = sentence("Reason", "moving home needs a known home altitude");
inline constexpr Sentence kSpeedTooLow = sentence("Reason", "the speed must be above 0 m/s");

// Of missions.
inline constexpr Sentence kMissionUnderWay = sentence("Reason", "another mission transfer is under way");
inline constexpr Sentence kNoFence = sentence(
    "Reason", "the autopilot does not say that the mission protocol reaches its fence: it could take this for its mission");
inline constexpr Sentence kNoRally = sentence(
    "Reason",
    "the autopilot does not say that the mission protocol reaches its rally points: it could take this for its mission");
inline constexpr Sentence kCapabilitiesUnknown = sentence(
    "Reason", "the autopilot does not answer what it can do (AUTOPILOT_VERSION): it could take this for its mission");
/// Why a list that was read or sent may not be the vehicle's any more.
inline constexpr Sentence kPlanChanged = sentence("Reason", "changed by another station");
inline constexpr Sentence kPlanCount = sentence("Reason", "changed by another station: %1 items instead of %2");
inline constexpr Sentence kPlanIncomplete = sentence("Reason", "a transfer to the vehicle was not completed");
inline constexpr Sentence kPlanNotOverwritten = sentence("Reason",
                                                         "what the vehicle has was %1; read it again, or overwrite it");
inline constexpr Sentence kPlanReadAgain = sentence(
    "Reason", "the vehicle has other items than those that were edited: another station changed them; they were read again");
inline constexpr Sentence kTooManyItems = sentence("Reason", "a mission has at most %1 items");
inline constexpr Sentence kItemNotOnGlobe = sentence("Reason", "item %1 is not on the globe");
inline constexpr Sentence kItemRefused = sentence("Reason", "item %1, %2: %3"); // number, command, reason
inline constexpr Sentence kPlaceTooFar = sentence("Reason", "parameters 5 and 6 are too large for the mission protocol");
inline constexpr Sentence kNeedsWholeNumber = sentence(
    "Reason", "the mission protocol carries parameters 5 and 6 of this command as whole numbers only");
inline constexpr Sentence kItemMissing = sentence("Reason", "the vehicle does not send item %1");
inline constexpr Sentence kItemsNotRequested = sentence("Reason", "the vehicle stopped requesting items");
inline constexpr Sentence kUploadEndedEarly = sentence("Reason", "the vehicle ended the upload early");
inline constexpr Sentence kOnlyHome = sentence(
    "Reason", "the only item is the home position of a mission; to remove what the vehicle has, clear its list");
/// What happened to the first item of an upload.
inline constexpr Sentence kHomeInserted = sentence(
    "Reason",
    "this vehicle keeps its home position as item 0, which the mission lacked: it was inserted, and the items moved "
    "up by one");
inline constexpr Sentence kFirstItemIsHome = sentence(
    "Reason", "this vehicle keeps its home position as item 0, so that it does not fly to the first waypoint of the mission");
inline constexpr Sentence kHomeIsWaypoint = sentence(
    "Reason", "item 0 looks like the home position of an ArduPilot mission: this vehicle flies to it as its first waypoint");
inline constexpr Sentence kHomeLeftOut = sentence(
    "Reason", "the first item is the home position of a mission, which has no place in a list of this kind: it was left out");

// Of parameters.
inline constexpr Sentence kNoParameter = sentence("Reason", "a name of up to 16 characters and a number are needed");
inline constexpr Sentence kParametersMissing = sentence("Reason", "the vehicle does not send its parameters");
inline constexpr Sentence kParametersIncomplete = sentence("Reason", "only %1 of %2 parameters came");
/// Why the list is not whole: what came of it, and why the vehicle refused the rest.
inline constexpr Sentence kParametersRefused = sentence("Reason", "only %1 of %2 parameters came: %3");
inline constexpr Sentence kComponentIncomplete = sentence("Reason", "of component %1 only %2 of %3 parameters came");
inline constexpr Sentence kValueKept = sentence("Reason", "the vehicle keeps %1");
inline constexpr Sentence kOutOfType = sentence("Reason", "%1 does not fit the parameter, which takes %2 to %3");
inline constexpr Sentence kNotWhole = sentence("Reason", "%1 does not fit the parameter, which takes whole numbers");
inline constexpr Sentence kNotExact = sentence(
    "Reason", "this vehicle takes whole numbers as floats, which cannot hold %1; the nearest is %2");

// Of files.
inline constexpr Sentence kFileUnderWay = sentence("Reason", "another file transfer is under way");
inline constexpr Sentence kNoPath = sentence("Reason", "a path of up to %1 bytes is needed");
inline constexpr Sentence kContentTooLarge = sentence("Reason", "a file has at most %1 bytes");
inline constexpr Sentence kFileTooLarge = sentence("Reason", "the file is larger than %1 bytes");
inline constexpr Sentence kFolderTooLarge = sentence("Reason", "the folder has more than %1 entries");
inline constexpr Sentence kChecksumsDiffer = sentence("Reason", "the checksums of both ends differ");
inline constexpr Sentence kChecksumMissing = sentence("Reason", "the vehicle does not send the checksum");
inline constexpr Sentence kPartUnchecked = sentence("Reason", "without a checksum, the part that is kept cannot be used");
inline constexpr Sentence kSizeMissing = sentence("Reason", "the vehicle does not report the size of the file");
inline constexpr Sentence kFileUnlikePart = sentence("Reason", "the size of the file does not match the part that is kept");
inline constexpr Sentence kFileChanged = sentence("Reason", "the file changed while it was read");
inline constexpr Sentence kByteMissing = sentence("Reason", "the vehicle does not send byte %1");
inline constexpr Sentence kByteNotAccepted = sentence("Reason", "the vehicle does not accept byte %1");

// Of logs.
inline constexpr Sentence kLogsUnderWay = sentence("Reason", "another request for logs is under way");
inline constexpr Sentence kNoSuchLog = sentence("Reason", "the vehicle has no such log");
inline constexpr Sentence kLogsRemain = sentence("Reason", "the vehicle still has logs, or does not answer");
inline constexpr Sentence kLogsNotListed = sentence("Reason", "the vehicle does not list its logs");
inline constexpr Sentence kLogsNotListedArmed = sentence("Reason", "the vehicle does not list its logs while it is armed");
inline constexpr Sentence kBytesMissing = sentence("Reason", "the vehicle does not send byte %1 and following");
inline constexpr Sentence kLogTooLarge = sentence("Reason", "the log is larger than %1 bytes");
inline constexpr Sentence kLogUnlikePart = sentence("Reason", "the log does not match the part that is kept");
inline constexpr Sentence kLogChanged = sentence("Reason", "the log changed while it was read");

} // namespace reasons

/// Nothing was sent, because of this.
inline Reason nothingSent(Reason because)
{
    return reasons::kNothingSent(std::move(because));
}

} // namespace skyseal::vehicle
