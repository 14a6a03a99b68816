// Sets up, checks or removes MAVLink signing of the vehicle at the other end of a link, once: frames and time go in, frames and
// one outcome come out (https://mavlink.io/en/guide/message_signing.html). SETUP_SIGNING is not answered, so the outcome is
// read from the signatures of the vehicle's own frames, and from its answers to signed and to unsigned TIMESYNC requests.
//
// Sans-I/O. Input: handleFrame(), handleDeadline(). Output, after any input: pollTransmit() until it is empty, then outcome().
#pragma once

#include "core/base/clock.h"
#include "core/base/locked_memory.h"
#include "core/base/path.h"
#include "core/engine/agent/vehicle_key.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/signing.h"

#include <optional>

namespace skyseal::engine {

enum class SigningAction : std::uint8_t { SetUp, Check, Remove };

struct SigningOutcome
{
    enum class Finding : std::uint8_t {
        Works,           ///< the vehicle signs with the key, and accepts messages that are signed with it
        Refuses,         ///< the vehicle signs with the key, but does not answer messages that are signed with it
        NotSigned,       ///< the vehicle does not sign
        OtherKey,        ///< the vehicle signs with another key
        Armed,           ///< nothing was changed, since the vehicle is armed
        SeveralVehicles, ///< nothing was sent, since the target is ambiguous
        NoVehicle        ///< no autopilot was heard
    };
    Finding finding{};
    std::uint8_t systemId = 0;    ///< of the vehicle
    bool acceptsUnsigned = false; ///< the vehicle answers unsigned requests on this link as well
    bool reached = false;         ///< the requested result
};

/// Create with `new`: its pages are locked.
class SigningTask : public InLockedMemory
{
public:
    static constexpr Duration kListen = std::chrono::seconds(10);        ///< for the first heartbeat
    static constexpr Duration kSettle = std::chrono::milliseconds(1500); ///< for heartbeats of further vehicles
    static constexpr Duration kRepeatEvery = std::chrono::milliseconds(500);
    static constexpr int kChangeAttempts = 10, kLeastProbes = 3, kMostProbes = 10;

    SigningTask(SigningAction action, VehicleKey key, TimePoint now);
    ~SigningTask();

    void handleFrame(TimePoint now, const Path &from, const mavlink::Frame &frame);
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const { return m_deadline; }

    struct Transmit
    {
        Path to;
        ByteView bytes; ///< until the next call to this object
    };
    std::optional<Transmit> pollTransmit();
    /// nullopt while the task is in progress.
    const std::optional<SigningOutcome> &outcome() const { return m_outcome; }

private:
    using Finding = SigningOutcome::Finding;
    enum class Phase : std::uint8_t { Listening, Changing, Probing, Over };
    enum class Signature : std::uint8_t { None, Ours, Other };
    struct Vehicle
    {
        Path path;
        std::uint8_t system = 0, component = 0;
        bool isArmed = false;
        Signature signature = Signature::None; ///< of the newest frame
    };
    struct Outgoing
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> bytes;
        std::size_t size = 0;
    };

    void takeHeartbeat(TimePoint now, const Path &from, const mavlink::Frame &frame);
    Signature signatureOf(const mavlink::Frame &frame);
    void decide(TimePoint now);
    void change(TimePoint now);
    void probe(TimePoint now);
    void finish(Finding finding);
    template<typename Message> void send(const Message &message, bool isSigned);

    const SigningAction m_action;
    Key32 m_key;
    mavlink::FrameSigner m_signer;
    std::unique_ptr<keys::SigningTimeFile> m_times;
    Phase m_phase = Phase::Listening;
    TimePoint m_deadline;
    std::optional<Vehicle> m_vehicle;
    bool m_severalVehicles = false;
    int m_attempts = 0; ///< in this phase
    bool m_answeredSigned = false, m_answeredUnsigned = false;
    std::array<Outgoing, 2> m_out;
    std::size_t m_outCount = 0, m_outTaken = 0;
    std::optional<SigningOutcome> m_outcome;
};

} // namespace skyseal::engine
