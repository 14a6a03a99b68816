#include "core/engine/agent/signing_task.h"

#include "core/engine/agent/vehicle_routes.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/mavlink/autopilot_heartbeat.h"
#include "core/mavlink/messages.h"

#include <algorithm>
#include <utility>

namespace skyseal::engine {

namespace {

/// Timestamps of the TIMESYNC requests, to recognise their answers.
constexpr std::int64_t kSignedTicket = 0x7369'676e6564, kUnsignedTicket = 0x756e'73696764;

} // namespace

SigningTask::SigningTask(SigningAction action, VehicleKey key, TimePoint now)
    : m_action(action), m_key(std::move(key.key)),
      m_signer(m_key.clone(), VehicleSigning::kLinkId, key.times ? key.times->storedAtStart() : 0),
      m_times(std::move(key.times)), m_deadline(now + kListen)
{}

SigningTask::~SigningTask()
{
    for (Outgoing &out : m_out) // SETUP_SIGNING holds the key
        wipeSecret(out.bytes);
}

void SigningTask::handleFrame(TimePoint now, const Path &from, const mavlink::Frame &frame)
{
    if (m_phase == Phase::Over)
        return;
    if (VehicleRoutes::isVehicleHeartbeat(frame))
        takeHeartbeat(now, from, frame);
    if (!m_vehicle || frame.systemId() != m_vehicle->system || frame.componentId() != m_vehicle->component)
        return;
    m_vehicle->signature = signatureOf(frame);
    if (m_phase == Phase::Probing && frame.messageId() == mavlink::Timesync::kId) {
        const auto answer = mavlink::Timesync::decode(frame.payload());
        m_answeredSigned |= answer.tc1 != 0 && answer.ts1 == kSignedTicket;
        m_answeredUnsigned |= answer.tc1 != 0 && answer.ts1 == kUnsignedTicket;
    }
}

void SigningTask::takeHeartbeat(TimePoint now, const Path &from, const mavlink::Frame &frame)
{
    const bool isArmed = (mavlink::heartbeatOf(frame)->base_mode & mavlink::MAV_MODE_FLAG_SAFETY_ARMED) != 0;
    if (!m_vehicle) {
        m_vehicle = Vehicle{from, frame.systemId(), frame.componentId(), isArmed, {}};
        m_deadline = now + kSettle;
    } else if (m_vehicle->system == frame.systemId()) {
        m_vehicle->isArmed = isArmed;
    } else {
        m_severalVehicles = true;
    }
}

/// The signer's time follows that of the vehicle, as in VehicleSigning.
SigningTask::Signature SigningTask::signatureOf(const mavlink::Frame &frame)
{
    if (!frame.isSigned())
        return Signature::None;
    if (!mavlink::signatureMatches(frame, m_key))
        return Signature::Other;
    m_signer.advanceTo(mavlink::signatureTime(frame));
    return Signature::Ours;
}

void SigningTask::handleDeadline(TimePoint now)
{
    if (now < m_deadline)
        return;
    switch (m_phase) {
    case Phase::Listening: return decide(now);
    case Phase::Changing: return change(now);
    case Phase::Probing: return probe(now);
    case Phase::Over: return;
    }
}

void SigningTask::decide(TimePoint now)
{
    if (!m_vehicle)
        return finish(Finding::NoVehicle);
    if (m_severalVehicles)
        return finish(Finding::SeveralVehicles);
    if (m_vehicle->signature == Signature::Other)
        return finish(Finding::OtherKey);
    const bool isSigned = m_vehicle->signature == Signature::Ours;
    const bool isChange = m_action == SigningAction::SetUp ? !isSigned : m_action == SigningAction::Remove && isSigned;
    if (isChange && m_vehicle->isArmed)
        return finish(Finding::Armed);
    if (isChange) {
        m_phase = Phase::Changing;
        return change(now);
    }
    if (!isSigned)
        return finish(Finding::NotSigned);
    m_phase = Phase::Probing;
    probe(now);
}

void SigningTask::change(TimePoint now)
{
    const bool setsUp = m_action == SigningAction::SetUp;
    if (m_attempts > 0 && m_vehicle->signature == (setsUp ? Signature::Ours : Signature::None)) {
        if (!setsUp)
            return finish(Finding::NotSigned);
        m_attempts = 0;
        m_phase = Phase::Probing;
        return probe(now);
    }
    if (m_attempts++ == kChangeAttempts) {
        if (m_vehicle->signature == Signature::Ours)
            return finish(Finding::Refuses);
        return finish(m_vehicle->signature == Signature::Other ? Finding::OtherKey : Finding::NotSigned);
    }
    mavlink::SetupSigning setup{.target_system = m_vehicle->system, .target_component = m_vehicle->component};
    if (setsUp) {
        // The newest time of this signer: a vehicle that is set up again must not accept older frames.
        setup.initial_timestamp = std::max<std::uint64_t>(m_signer.lastTime(), 1);
        std::copy(m_key.view().begin(), m_key.view().end(), setup.secret_key.begin());
    }
    // Signed in both cases: a vehicle that does not check signatures ignores the signature, one that accepted an earlier copy
    // requires it.
    send(setup, true);
    wipeSecret(setup.secret_key.data(), setup.secret_key.size());
    m_deadline = now + kRepeatEvery;
}

void SigningTask::probe(TimePoint now)
{
    if ((m_answeredSigned && m_attempts >= kLeastProbes) || m_attempts == kMostProbes)
        return finish(m_answeredSigned ? Finding::Works : Finding::Refuses);
    ++m_attempts;
    send(mavlink::Timesync{.ts1 = kSignedTicket}, true);
    send(mavlink::Timesync{.ts1 = kUnsignedTicket}, false);
    m_deadline = now + kRepeatEvery;
}

void SigningTask::finish(Finding finding)
{
    if (m_times)
        m_times->store(m_signer.lastTime() + VehicleSigning::kAhead);
    m_phase = Phase::Over;
    m_deadline = kNever;
    const bool wanted = finding == (m_action == SigningAction::Remove ? Finding::NotSigned : Finding::Works);
    m_outcome = SigningOutcome{finding, m_vehicle ? m_vehicle->system : std::uint8_t(0), m_answeredUnsigned, wanted};
}

template<typename Message> void SigningTask::send(const Message &message, bool isSigned)
{
    if (std::exchange(m_outTaken, 0) > 0 || m_outCount == m_out.size())
        m_outCount = 0;
    mavlink::FrameWriter writer(m_vehicle->system, mavlink::MAV_COMP_ID_ONBOARD_COMPUTER);
    if (isSigned)
        writer.setSigner(&m_signer);
    Outgoing &out = m_out[m_outCount++];
    out.size = writer.write(message, out.bytes).size();
}

std::optional<SigningTask::Transmit> SigningTask::pollTransmit()
{
    if (m_outTaken == m_outCount)
        return std::nullopt;
    const Outgoing &next = m_out[m_outTaken++];
    return Transmit{m_vehicle->path, ByteView(next.bytes).first(next.size)};
}

} // namespace skyseal::engine
