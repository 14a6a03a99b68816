#include "core/engine/agent/vehicle_signing.h"

#include "core/base/locked_memory.h"
#include "core/engine/agent/vehicle_key.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/signing.h"

#include <algorithm>

namespace skyseal::engine {

using mavlink::SignatureVerdict;

namespace {

/// Radios, which have no key, insert these between the frames of the vehicle. Autopilots accept them as well.
bool mayBeUnsigned(std::uint32_t messageId)
{
    return messageId == mavlink::RadioStatus::kId || messageId == mavlink::Radio::kId;
}

std::uint64_t refusedOf(const SigningCounters &counters)
{
    return counters.unsignedRefused + counters.wrong + counters.old;
}

} // namespace

struct VehicleSigning::Keyed : InLockedMemory
{
    Keyed(Key32 key, Time start) : signer(key.clone(), kLinkId, start), verifier(std::move(key), start) {}

    mavlink::FrameSigner signer;
    mavlink::SignatureVerifier verifier;
};

VehicleSigning::VehicleSigning(VehicleKey key, bool acceptUnsigned)
    : m_keyed(std::make_unique<Keyed>(std::move(key.key), key.times ? key.times->storedAtStart() : 0)),
      m_times(std::move(key.times)), m_acceptUnsigned(acceptUnsigned), m_stored(m_keyed->signer.lastTime())
{}

VehicleSigning::~VehicleSigning() = default;

bool VehicleSigning::accept(ByteView frame)
{
    const SignatureVerdict verdict = m_keyed->verifier.check(frame);
    m_refusedFor = verdict;
    switch (verdict) {
    case SignatureVerdict::Good:
        ++m_counters.verified;
        m_keyed->signer.advanceTo(m_keyed->verifier.newestTime());
        storeTime();
        return true;
    case SignatureVerdict::Unsigned:
        if (m_acceptUnsigned || mayBeUnsigned(mavlink::messageIdOf(frame))) {
            ++m_counters.unsignedAccepted;
            return true;
        }
        return refuse(m_counters.unsignedRefused, Kind::Unsigned);
    case SignatureVerdict::Wrong: return refuse(m_counters.wrong, Kind::Wrong);
    case SignatureVerdict::Replayed:
    case SignatureVerdict::TooOld:
    case SignatureVerdict::TooManyStreams: break;
    }
    return refuse(m_counters.old, Kind::Old);
}

ByteView VehicleSigning::catchUp(TimePoint now, ByteView refused)
{
    const bool isOld = m_refusedFor == SignatureVerdict::Replayed || m_refusedFor == SignatureVerdict::TooOld;
    if (!isOld || now < m_catchUpDue)
        return {};
    m_catchUpDue = now + kCatchUpEvery;
    mavlink::FrameWriter writer(mavlink::systemIdOf(refused), mavlink::MAV_COMP_ID_ONBOARD_COMPUTER);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> request;
    // No station waits for the answer: its ts1 matches no request of a station.
    return signedCopy(writer.write(mavlink::Timesync{.ts1 = 1}, request));
}

ByteView VehicleSigning::sign(ByteView frame, bool mayCommand)
{
    if (mavlink::messageIdOf(frame) == mavlink::SetupSigning::kId) {
        refuse(m_counters.keyChanges, Kind::KeyChange);
        return {};
    }
    if (!hasPlace(frame, mayCommand)) {
        refuse(m_counters.tooManySenders, Kind::TooManySenders);
        return {};
    }
    const ByteView out = signedCopy(frame);
    if (out.empty())
        refuse(m_counters.unsignable, Kind::Unsignable);
    else
        ++m_counters.signedFrames;
    return out;
}

ByteView VehicleSigning::signedCopy(ByteView frame)
{
    const ByteView out = m_keyed->signer.signCopy(frame, m_buffer);
    storeTime();
    return out;
}

/// Always returns false, for the return statements of the callers.
bool VehicleSigning::refuse(std::uint64_t &counter, Kind kind)
{
    ++counter;
    ++pending(kind).frames;
    return false;
}

bool VehicleSigning::hasPlace(ByteView frame, bool mayCommand)
{
    const std::uint8_t system = mavlink::systemIdOf(frame), component = mavlink::componentIdOf(frame);
    const auto end = m_senders.begin() + static_cast<std::ptrdiff_t>(m_senderCount);
    const auto known = std::find_if(
        m_senders.begin(), end, [&](const Sender &sender) { return sender.system == system && sender.component == component; });
    if (known != end) {
        if (mayCommand && !known->mayCommand) { // the sender no longer counts as an observer
            known->mayCommand = true;
            --m_askerCount;
        }
        return true;
    }
    if (m_senderCount == kMostSenders || (!mayCommand && m_askerCount == kMostAskers))
        return false;
    m_senders[m_senderCount++] = {system, component, mayCommand};
    m_askerCount += !mayCommand;
    return true;
}

void VehicleSigning::storeTime()
{
    const Time now = m_keyed->signer.lastTime();
    if (now + kLeastAhead <= m_stored || !m_times)
        return;
    m_stored = std::min(now + kAhead, mavlink::kMaxSigningTime);
    m_times->store(m_stored);
}

std::vector<VehicleSignatures> VehicleSigning::takeReports(TimePoint now)
{
    std::vector<VehicleSignatures> out;
    const auto report = [&](Kind kind, std::uint64_t frames, std::string problem = {}) {
        Pending &of = pending(kind);
        if (now < of.due)
            return false;
        of = {0, now + kReportEvery};
        out.push_back({kind, frames, std::move(problem)});
        return true;
    };
    for (std::size_t i = 0; i < m_pending.size(); ++i) {
        if (m_pending[i].frames > 0)
            report(static_cast<Kind>(i), m_pending[i].frames);
    }
    const std::uint64_t refused = refusedOf(m_counters);
    if (m_counters.verified > m_verifiedAtReport)
        m_verifiedReported = m_verifiedReported || report(Kind::Verified, m_counters.verified - m_verifiedAtReport);
    else if (refused > m_refusedAtReport) // only refused frames: the next good one is reported
        m_verifiedReported = false;
    m_verifiedAtReport = m_counters.verified;
    m_refusedAtReport = refused;
    if (std::string problem = m_times ? m_times->problem() : std::string(); !problem.empty())
        report(Kind::TimeNotStored, 0, std::move(problem));
    return out;
}

} // namespace skyseal::engine
