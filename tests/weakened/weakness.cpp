// The library's weakened() in programs that are built to be attacked: true for what SKYSEAL_WEAKNESS names, a list with
// commas. A name that does not exist ends the program, so that a proof cannot rest on a slip of the pen.
#include "core/base/declassified.h"
#include "core/base/weakness.h"

#include <bitset>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#if __has_include(<valgrind/memcheck.h>)
#include <valgrind/memcheck.h>
#else
#define VALGRIND_MAKE_MEM_DEFINED(bytes, count) (static_cast<void>(bytes), static_cast<void>(count))
#endif

namespace skyseal {

namespace {

struct Named
{
    Weakness weakness;
    std::string_view name;
};

constexpr Named kNames[] = {
    {Weakness::NoTagCheck, "NoTagCheck"},
    {Weakness::NoEncryption, "NoEncryption"},
    {Weakness::SharedNonce, "SharedNonce"},
    {Weakness::NoAssociatedData, "NoAssociatedData"},
    {Weakness::NoDirections, "NoDirections"},
    {Weakness::SameKeysEveryEpoch, "SameKeysEveryEpoch"},
    {Weakness::PaddingAccepted, "PaddingAccepted"},
    {Weakness::NoReplayWindow, "NoReplayWindow"},
    {Weakness::NoCloneCheck, "NoCloneCheck"},
    {Weakness::WindowBeforeTag, "WindowBeforeTag"},
    {Weakness::RoamOnForged, "RoamOnForged"},
    {Weakness::RoamOnLate, "RoamOnLate"},
    {Weakness::NoTrial, "NoTrial"},
    {Weakness::ReturnToUnheard, "ReturnToUnheard"},
    {Weakness::TrialByAnyEcho, "TrialByAnyEcho"},
    {Weakness::TrialByRepeatedStamp, "TrialByRepeatedStamp"},
    {Weakness::NoHardStop, "NoHardStop"},
    {Weakness::NoOvertakenLimit, "NoOvertakenLimit"},
    {Weakness::NoAgeLimit, "NoAgeLimit"},
    {Weakness::OldReports, "OldReports"},
    {Weakness::LifeWithoutReports, "LifeWithoutReports"},
    {Weakness::CommandsAfterClose, "CommandsAfterClose"},
    {Weakness::KeepOldKeys, "KeepOldKeys"},
    {Weakness::NoWipe, "NoWipe"},
    {Weakness::NoSwitchExchange, "NoSwitchExchange"},
    {Weakness::NoMemoryLock, "NoMemoryLock"},
    {Weakness::NoFrameOrder, "NoFrameOrder"},
    {Weakness::CommitEarly, "CommitEarly"},
    {Weakness::NoMac1, "NoMac1"},
    {Weakness::NoHandshakeTag, "NoHandshakeTag"},
    {Weakness::NoPrologue, "NoPrologue"},
    {Weakness::NoEphemeralMix, "NoEphemeralMix"},
    {Weakness::AcceptLowerCounter, "AcceptLowerCounter"},
    {Weakness::NoConfirmation, "NoConfirmation"},
    {Weakness::NoPinning, "NoPinning"},
    {Weakness::NoOfferRecheck, "NoOfferRecheck"},
    {Weakness::NoRateLimit, "NoRateLimit"},
    {Weakness::AnswerTwice, "AnswerTwice"},
    {Weakness::NoForm, "NoForm"},
    {Weakness::NotifyEverything, "NotifyEverything"},
    {Weakness::SharedNotices, "SharedNotices"},
    {Weakness::TrustAnnouncements, "TrustAnnouncements"},
    {Weakness::NoCookie, "NoCookie"},
    {Weakness::HurryCalls, "HurryCalls"},
    {Weakness::CallRouters, "CallRouters"},
    {Weakness::RetryUnproven, "RetryUnproven"},
    {Weakness::PairOnOneYes, "PairOnOneYes"},
    {Weakness::NoPassphrase, "NoPassphrase"},
    {Weakness::NoCommitment, "NoCommitment"},
    {Weakness::OpenAgain, "OpenAgain"},
    {Weakness::GuessAgain, "GuessAgain"},
    {Weakness::ShowNewest, "ShowNewest"},
    {Weakness::LoosePart, "LoosePart"},
    {Weakness::NoScanLimit, "NoScanLimit"},
    {Weakness::NoTunnelPadding, "NoTunnelPadding"},
    {Weakness::NoFileCheck, "NoFileCheck"},
    {Weakness::NoFileChecksum, "NoFileChecksum"},
    {Weakness::Leak, "Leak"},
    {Weakness::CountersOneByOne, "CountersOneByOne"},
    {Weakness::StopWithoutDisk, "StopWithoutDisk"},
    {Weakness::AnyName, "AnyName"},
    {Weakness::NotifiedOnly, "NotifiedOnly"},
    {Weakness::NoRoleCheck, "NoRoleCheck"},
    {Weakness::Misreadable, "Misreadable"},
    {Weakness::VehicleTakesAnyId, "VehicleTakesAnyId"},
    {Weakness::UnlimitedClaims, "UnlimitedClaims"},
    {Weakness::AnyStreamRate, "AnyStreamRate"},
    {Weakness::UnlimitedQuestions, "UnlimitedQuestions"},
    {Weakness::NoSenderCheck, "NoSenderCheck"},
    {Weakness::ClearAccepted, "ClearAccepted"},
    {Weakness::SameRandomEveryLife, "SameRandomEveryLife"},
    {Weakness::Impatient, "Impatient"},
    {Weakness::CountersFromClock, "CountersFromClock"},
};

std::bitset<256> selected()
{
    std::bitset<256> out;
    const char *text = std::getenv("SKYSEAL_WEAKNESS");
    std::string_view rest = text ? text : "";
    while (!rest.empty()) {
        const std::string_view name = rest.substr(0, rest.find(','));
        rest.remove_prefix(name.size() + (name.size() < rest.size() ? 1 : 0));
        bool found = false;
        for (const Named &known : kNames) {
            if (known.name == name) {
                out.set(static_cast<std::size_t>(known.weakness));
                found = true;
            }
        }
        if (!found) {
            std::fprintf(stderr, "no weakness is called '%.*s'\n", static_cast<int>(name.size()), name.data());
            std::abort();
        }
    }
    return out;
}

} // namespace

bool weakened(Weakness weakness)
{
    static const std::bitset<256> kSelected = selected();
    return kSelected.test(static_cast<std::size_t>(weakness));
}

void declassify(const void *bytes, std::size_t count)
{
    static_cast<void>(VALGRIND_MAKE_MEM_DEFINED(bytes, count));
}

} // namespace skyseal
