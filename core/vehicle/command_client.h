// Transmission of commands: COMMAND_LONG or COMMAND_INT, repeated with a rising confirmation count until a COMMAND_ACK arrives;
// the time-out grows while the vehicle reports progress. https://mavlink.io/en/services/command.html
//
// An acknowledgement names only the MAV_CMD, so only one command of a number is in progress at a time; others of the same
// number wait for it or replace it.
#pragma once

#include "core/vehicle/micro_protocol.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace skyseal::vehicle {

/// A command as it is sent.
struct CommandOrder
{
    std::uint16_t command = 0; ///< MAV_CMD
    float parameters[7]{};     ///< of COMMAND_INT only the first four and the seventh
    bool asInt = false;        ///< COMMAND_INT, whose coordinates are exact
    std::uint8_t frame = 0;    ///< MAV_FRAME, of COMMAND_INT
    std::int32_t x = 0, y = 0; ///< of COMMAND_INT: degrees × 1e7
};

enum class CommandTicket : std::uint32_t {};

struct CommandAnswer
{
    enum class Kind : std::uint8_t { Answered, TimedOut, Replaced };

    CommandTicket ticket{};
    Kind kind{};
    std::uint8_t result = 0; ///< MAV_RESULT, when answered
    bool repeated = false;   ///< the command was sent more than once, and any of these may be the one that is answered
};

class CommandClient
{
public:
    static constexpr Duration kAckTimeout = std::chrono::seconds(1);
    static constexpr int kAttempts = 5;
    static constexpr Duration kProgressTimeout = std::chrono::seconds(10); ///< after each report of progress
    static constexpr std::size_t kMaxPending = 64;

    /// `context` must outlive this object.
    explicit CommandClient(VehicleContext &context) : m_context(context) {}

    /// `replace`: ends commands of the same number instead of waiting for them.
    CommandTicket send(TimePoint now, const CommandOrder &order, bool replace);
    /// A COMMAND_ACK to this station. Returns false if no command was waiting for it.
    bool handleAck(TimePoint now, std::uint16_t command, std::uint8_t result);
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;
    /// Forgets a command, without an answer; it is not sent again.
    void cancel(TimePoint now, CommandTicket ticket);
    /// Forgets all commands without an answer.
    void clear() { m_pending.clear(); }

    std::optional<CommandAnswer> poll();

private:
    struct Pending
    {
        CommandTicket ticket{};
        CommandOrder order;
        int attempts = 0; ///< 0 = waits for another command of the same number
        TimePoint deadline = kNever;
        bool inProgress = false;
    };

    void transmit(TimePoint now, Pending &pending);
    void startWaiting(TimePoint now, std::uint16_t command);
    bool isInProgress(std::uint16_t command) const;

    VehicleContext &m_context;
    std::uint32_t m_lastTicket = 0;
    std::vector<Pending> m_pending; ///< in the order of sending
    std::deque<CommandAnswer> m_answers;
};

} // namespace skyseal::vehicle
