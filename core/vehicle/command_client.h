// MAVLink's command protocol: COMMAND_LONG or COMMAND_INT until a COMMAND_ACK comes, with a rising confirmation count, and
// patience while the vehicle reports progress. https://mavlink.io/en/services/command.html
//
// An acknowledgement names only the number of the command, so only one command of a number is under way at a time; others of
// the same number wait for it, or replace it.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/message_queue.h"
#include "core/vehicle/vehicle_config.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace skyseal::vehicle {

/// A command as it goes out.
struct CommandOrder
{
    std::uint16_t command = 0; ///< MAV_CMD
    float parameters[7]{};     ///< of COMMAND_INT only the first four and the seventh
    bool asInt = false;        ///< COMMAND_INT, which carries places exactly
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
};

class CommandClient
{
public:
    static constexpr Duration kAckTimeout = std::chrono::seconds(1);
    static constexpr int kAttempts = 5;
    static constexpr Duration kProgressTimeout = std::chrono::seconds(10); ///< after each report of progress
    static constexpr std::size_t kMostWaiting = 64;

    explicit CommandClient(const Addressing &addressing) : m_addressing(addressing) {}

    /// `replace`: ends what is under way with the same number, instead of waiting for it.
    CommandTicket send(TimePoint now, const CommandOrder &order, bool replace, MessageQueue &outbox);
    /// A COMMAND_ACK for us. False when nothing here was waiting for it.
    bool handleAck(TimePoint now, std::uint16_t command, std::uint8_t result, MessageQueue &outbox);
    void handleDeadline(TimePoint now, MessageQueue &outbox);
    TimePoint nextDeadline() const;

    std::optional<CommandAnswer> poll();

private:
    struct Pending
    {
        CommandTicket ticket{};
        CommandOrder order;
        int attempts = 0; ///< 0 = waits for another of its number
        TimePoint deadline = kNever;
        bool inProgress = false;
    };

    void transmit(TimePoint now, Pending &pending, MessageQueue &outbox);
    void startWaiting(TimePoint now, std::uint16_t command, MessageQueue &outbox);
    bool isUnderWay(std::uint16_t command) const;

    Addressing m_addressing;
    std::uint32_t m_lastTicket = 0;
    std::vector<Pending> m_pending; ///< in the order of sending
    std::deque<CommandAnswer> m_answers;
};

} // namespace skyseal::vehicle
