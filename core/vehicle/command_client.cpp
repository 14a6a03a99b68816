#include "core/vehicle/command_client.h"

#include <algorithm>

namespace skyseal::vehicle {

CommandTicket CommandClient::send(TimePoint now, const CommandOrder &order, bool replace)
{
    const auto ticket = CommandTicket{++m_lastTicket};
    if (replace) {
        std::erase_if(m_pending, [&](const Pending &pending) {
            if (pending.order.command != order.command)
                return false;
            m_answers.push_back({pending.ticket, CommandAnswer::Kind::Replaced, 0});
            return true;
        });
    }
    if (m_pending.size() >= kMaxPending) {
        m_answers.push_back({ticket, CommandAnswer::Kind::TimedOut, 0});
        return ticket;
    }
    m_pending.push_back({ticket, order});
    startWaiting(now, order.command);
    return ticket;
}

bool CommandClient::handleAck(TimePoint now, std::uint16_t command, std::uint8_t result)
{
    const auto found = std::find_if(m_pending.begin(), m_pending.end(), [command](const Pending &pending) {
        return pending.order.command == command && pending.attempts > 0;
    });
    if (found == m_pending.end())
        return false;
    if (result == mavlink::MAV_RESULT_IN_PROGRESS) {
        found->inProgress = true;
        found->deadline = now + kProgressTimeout;
        return true;
    }
    m_answers.push_back({found->ticket, CommandAnswer::Kind::Answered, result, found->attempts > 1});
    m_pending.erase(found);
    startWaiting(now, command);
    return true;
}

void CommandClient::handleDeadline(TimePoint now)
{
    for (std::size_t i = 0; i < m_pending.size();) {
        Pending &pending = m_pending[i];
        if (now < pending.deadline) {
            ++i;
        } else if (!pending.inProgress && pending.attempts < kAttempts) {
            transmit(now, pending);
            ++i;
        } else {
            const std::uint16_t command = pending.order.command;
            m_answers.push_back({pending.ticket, CommandAnswer::Kind::TimedOut, 0});
            m_pending.erase(m_pending.begin() + static_cast<std::ptrdiff_t>(i));
            startWaiting(now, command);
        }
    }
}

void CommandClient::cancel(TimePoint now, CommandTicket ticket)
{
    const auto found = std::ranges::find(m_pending, ticket, &Pending::ticket);
    if (found == m_pending.end())
        return;
    const std::uint16_t command = found->order.command;
    m_pending.erase(found);
    startWaiting(now, command);
}

TimePoint CommandClient::nextDeadline() const
{
    TimePoint next = kNever;
    for (const Pending &pending : m_pending)
        next = std::min(next, pending.deadline);
    return next;
}

std::optional<CommandAnswer> CommandClient::poll()
{
    if (m_answers.empty())
        return std::nullopt;
    const CommandAnswer answer = m_answers.front();
    m_answers.pop_front();
    return answer;
}

void CommandClient::transmit(TimePoint now, Pending &pending)
{
    const CommandOrder &order = pending.order;
    if (order.asInt) {
        mavlink::CommandInt message;
        message.command = order.command;
        message.frame = order.frame;
        message.param1 = order.parameters[0];
        message.param2 = order.parameters[1];
        message.param3 = order.parameters[2];
        message.param4 = order.parameters[3];
        message.x = order.x;
        message.y = order.y;
        message.z = order.parameters[6];
        m_context.send(message);
    } else {
        mavlink::CommandLong message;
        message.command = order.command;
        message.confirmation = static_cast<std::uint8_t>(pending.attempts);
        message.param1 = order.parameters[0];
        message.param2 = order.parameters[1];
        message.param3 = order.parameters[2];
        message.param4 = order.parameters[3];
        message.param5 = order.parameters[4];
        message.param6 = order.parameters[5];
        message.param7 = order.parameters[6];
        m_context.send(message);
    }
    ++pending.attempts;
    pending.deadline = now + kAckTimeout;
}

void CommandClient::startWaiting(TimePoint now, std::uint16_t command)
{
    if (isInProgress(command))
        return;
    const auto next = std::find_if(m_pending.begin(), m_pending.end(),
                                   [command](const Pending &pending) { return pending.order.command == command; });
    if (next != m_pending.end())
        transmit(now, *next);
}

bool CommandClient::isInProgress(std::uint16_t command) const
{
    return std::any_of(m_pending.begin(), m_pending.end(),
                       [command](const Pending &pending) { return pending.order.command == command && pending.attempts > 0; });
}

} // namespace skyseal::vehicle
