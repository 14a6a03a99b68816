// Carries out wishes: tries each way of a plan, listens for the acknowledgement and for the sign by which the vehicle shows
// that the wish came true, and says once how it ended, in the vehicle's own words where it gave any.
//
//     Asking ── accepted ──→ Watching ── sign seen ──→ accepted
//       │ │                      └────── other sign ──→ timed out
//       │ └── not supported, no answer ──→ next way (Asking or Repeating)
//       └── refused ──→ Holding, until a STATUSTEXT says why ──→ refused
//     Repeating a message ── sign seen, or acknowledged ──→ accepted
#pragma once

#include "core/vehicle/command_client.h"
#include "core/vehicle/command_plan.h"
#include "core/vehicle/vehicle_command.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::vehicle {

class Commander
{
public:
    static constexpr Duration kRepeatInterval = std::chrono::seconds(1);
    static constexpr int kRepeats = 5;
    /// Heartbeats come once a second; two of them may be lost.
    static constexpr Duration kWatch = std::chrono::milliseconds(3500);
    /// ArduPilot acknowledges first and gives its reason a moment later.
    static constexpr Duration kHold = std::chrono::milliseconds(700);
    static constexpr std::size_t kMostActions = 32;

    explicit Commander(const Addressing &addressing) : m_addressing(addressing), m_client(addressing) {}

    void begin(TimePoint now, CommandId id, const VehicleCommand &command, const VehicleState &state, MessageQueue &outbox);

    void handleAck(TimePoint now, std::uint16_t command, std::uint8_t result, const VehicleState &state, MessageQueue &outbox);
    void handleText(TimePoint now, std::uint8_t severity, const std::string &text);
    /// After a heartbeat was taken into `state`.
    void handleHeartbeat(TimePoint now, const VehicleState &state);
    void handleMissionCurrent(std::uint16_t index);
    void handlePositionTarget(std::int32_t latitude, std::int32_t longitude);
    void handleDeadline(TimePoint now, const VehicleState &state, MessageQueue &outbox);
    TimePoint nextDeadline() const;

    std::optional<CommandResult> poll();

private:
    enum class Phase : std::uint8_t { Asking, Repeating, Watching, Holding };

    struct Action
    {
        CommandId id{};
        CommandPlan plan;
        std::size_t way = 0;
        Phase phase{};
        std::optional<CommandTicket> ticket;
        TimePoint deadline = kNever;
        int repeats = 0;
        bool trueBefore = false;  ///< the sign was there before anything was sent, so alone it proves nothing
        bool mayAskAgain = false; ///< the acknowledgement may have been that of the wish which this one replaced
        bool heardSince = false;  ///< a heartbeat since the acknowledgement
        std::uint8_t result = 0;
        std::string words; ///< the vehicle's, since the wish began
        bool done = false;
    };

    void startWay(TimePoint now, Action &action, MessageQueue &outbox);
    void repeat(TimePoint now, Action &action, MessageQueue &outbox);
    void nextWay(TimePoint now, Action &action, CommandOutcome otherwise, std::string reason, MessageQueue &outbox);
    void takeAnswers(TimePoint now, const VehicleState &state, MessageQueue &outbox);
    void answered(TimePoint now, Action &action, std::uint8_t result, const VehicleState &state, MessageQueue &outbox);
    void watchEnded(TimePoint now, Action &action, const VehicleState &state, MessageQueue &outbox);
    template<typename T, typename Predicate> void seen(Predicate matches);
    void finish(Action &action, CommandOutcome outcome, std::string reason);
    void forgetDone();

    Addressing m_addressing;
    CommandClient m_client;
    std::vector<Action> m_actions;
    std::deque<CommandResult> m_results;
};

} // namespace skyseal::vehicle
