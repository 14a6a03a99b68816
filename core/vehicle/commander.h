// Client for commands: tries each alternative of a plan, waits for the acknowledgement and for the state change that confirms
// the command, and reports one CommandResult, with the vehicle's status texts as the reason of a refusal.
//
//     Requesting ── accepted ──→ Confirming ── effect reported ──→ accepted
//       │ │                          └──────── other state ──────→ timed out
//       │ └── not supported, no answer ──→ next alternative (Requesting or Repeating)
//       └── refused ──→ AwaitingReason, until a STATUSTEXT arrives ──→ refused
//                          └── of a repetition: effect reported ──→ accepted
//     Repeating a message ── effect reported, or acknowledged ──→ accepted
//     accepted, of a step that prepares the command ──→ next step (Requesting or Repeating)
//
// A vehicle whose acknowledgement was lost may refuse the repetition because it has carried out the command: a copter that
// climbs refuses to take off. So the refusal of a repetition counts only if the effect is not reported.
//
// A message that needs a mode requests the mode first. A later command that changes the mode ends an earlier one, which would
// undo it by being sent again.
#pragma once

#include "core/vehicle/command_client.h"
#include "core/vehicle/command_plan.h"
#include "core/vehicle/micro_protocol.h"

#include <optional>
#include <string>
#include <vector>

namespace skyseal::vehicle {

class Commander : public MicroProtocol
{
public:
    static constexpr Duration kRepeatInterval = std::chrono::seconds(1);
    static constexpr int kRepeats = 5;
    /// Heartbeats are sent once a second; two of them may be lost.
    static constexpr Duration kConfirmTimeout = std::chrono::milliseconds(3500);
    /// ArduPilot sends the reason of a refusal shortly after the acknowledgement.
    static constexpr Duration kReasonTimeout = std::chrono::milliseconds(700);
    /// A deadline that is handled later than this shows that the program did not run, as on a computer that slept.
    /// Earlier commands are not sent again then: the operator does not expect them any more.
    static constexpr Duration kMostDelay = std::chrono::seconds(3);
    static constexpr std::size_t kMaxActions = 32;
    /// Steps that prepare a command: entering a mode, arming.
    static constexpr int kMostPrepared = 2;

    explicit Commander(VehicleContext &context) : MicroProtocol(context), m_client(context) {}

    /// VehicleCommand.
    bool perform(TimePoint now, RequestId id, const Request &request) override;
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleHeartbeat(TimePoint now) override;
    void handleText(const StatusText &text) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override;

private:
    enum class Phase : std::uint8_t { Requesting, Repeating, Confirming, AwaitingReason };

    struct Action
    {
        RequestId id{};
        CommandPlan plan; ///< of the step under way
        std::size_t alternative = 0;
        Phase phase{};
        std::optional<CommandTicket> ticket;
        TimePoint deadline = kNever;
        int repeats = 0;
        int prepared = 0;          ///< steps that took effect
        bool startsFlight = false; ///< so that disarming ends it
        bool changesMode = false;  ///< so that the next command that does replaces it
        bool awaitsMode = false;   ///< of a message that needs one: it is requested
        std::uint32_t modeBefore = 0;
        bool wasInEffect = false;   ///< before anything was sent, so the effect alone proves nothing
        bool mayRetry = false;      ///< the acknowledgement may belong to the command that this one replaced
        bool heartbeatSeen = false; ///< since the acknowledgement
        bool effectCounts = false;  ///< the refusal that awaits its reason is that of a repetition
        std::uint8_t result = 0;    ///< MAV_RESULT
        std::string texts;          ///< of the vehicle since the command began
        bool done = false;
    };

    void begin(TimePoint now, RequestId id, const VehicleCommand &command);
    void adopt(Action &action, CommandPlan plan) const;
    void replaceOthers(TimePoint now, Action &action);
    void handleAck(TimePoint now, std::uint16_t command, std::uint8_t result);
    void startAlternative(TimePoint now, Action &action);
    void nextAlternative(TimePoint now, Action &action, CommandOutcome otherwise, Reason reason);
    void repeat(TimePoint now, Action &action);
    void followMode(TimePoint now, Action &action);
    void takeAnswers(TimePoint now);
    void tookEffect(TimePoint now, Action &action, Reason reason = {});
    void answered(TimePoint now, Action &action, std::uint8_t result, bool repeated);
    void confirmationTimedOut(TimePoint now, Action &action);
    template<typename T, typename Predicate> void effectReported(TimePoint now, Predicate matches);
    Reason withStep(const Action &action, Reason reason) const;
    void finish(Action &action, CommandOutcome outcome, Reason reason);
    void giveUpAfterSleep(TimePoint now);
    void removeDone();

    CommandClient m_client;
    std::vector<Action> m_actions;
};

} // namespace skyseal::vehicle
