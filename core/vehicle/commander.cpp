#include "core/vehicle/commander.h"

#include "core/mavlink/enums.h"
#include "core/vehicle/flight_modes.h"
#include "core/vehicle/result_text.h"

#include <algorithm>
#include <cstdlib>

namespace skyseal::vehicle {

namespace {

constexpr std::size_t kLongestText = 300;

bool isTrue(const Sign &sign, const VehicleState &state)
{
    if (const auto *armed = std::get_if<ArmedIs>(&sign))
        return state.armed == armed->armed;
    if (const auto *mode = std::get_if<ModeIs>(&sign))
        return state.customMode == mode->customMode;
    if (const auto *item = std::get_if<MissionItemIs>(&sign))
        return state.missionCurrent == item->index;
    return false;
}

/// Whether the sign comes with heartbeats, so that an acknowledgement alone is not the whole story.
bool comesWithHeartbeats(const Sign &sign, const VehicleState &state)
{
    // PX4 moves on from some modes at once (take-off, land), so its word has to do.
    return std::holds_alternative<ArmedIs>(sign)
        || (std::holds_alternative<ModeIs>(sign) && !VehicleKind{state.type, state.autopilot}.isPx4());
}

std::string whatItReports(const Sign &sign, const VehicleState &state)
{
    if (std::holds_alternative<ArmedIs>(sign))
        return state.armed ? "armed" : "disarmed";
    if (std::holds_alternative<ModeIs>(sign))
        return "the mode " + state.mode;
    return "mission item " + std::to_string(state.missionCurrent);
}

} // namespace

void Commander::begin(TimePoint now, CommandId id, const VehicleCommand &command, const VehicleState &state,
                      MessageQueue &outbox)
{
    auto plan = planCommand(command, state, m_addressing);
    Action action;
    action.id = id;
    if (!plan) {
        finish(action, CommandOutcome::Refused, "nothing was sent: " + plan.error());
        return;
    }
    if (m_actions.size() >= kMostActions) {
        finish(action, CommandOutcome::Refused, "nothing was sent: too many commands are waiting for answers");
        return;
    }
    action.plan = std::move(*plan);
    action.trueBefore = isTrue(action.plan.sign, state);
    if (action.plan.replaces) {
        for (Action &other : m_actions) {
            if (!other.plan.replaces || other.plan.sign.index() != action.plan.sign.index() || other.phase == Phase::Holding
                || std::holds_alternative<std::monostate>(other.plan.sign))
                continue;
            finish(other, CommandOutcome::Refused, "replaced by a newer command");
            action.mayAskAgain = true;
        }
        forgetDone();
    }
    m_actions.push_back(std::move(action));
    startWay(now, m_actions.back(), outbox);
    takeAnswers(now, state, outbox);
}

void Commander::handleAck(TimePoint now, std::uint16_t command, std::uint8_t result, const VehicleState &state,
                          MessageQueue &outbox)
{
    if (!m_client.handleAck(now, command, result, outbox)) {
        // Some firmware acknowledges messages as well, by their message id.
        for (Action &action : m_actions) {
            const auto *message = std::get_if<RepeatedMessage>(&action.plan.ways[action.way]);
            if (action.phase == Phase::Repeating && message && message->message.id == command
                && result != mavlink::MAV_RESULT_IN_PROGRESS)
                answered(now, action, result, state, outbox);
        }
        forgetDone();
        return;
    }
    takeAnswers(now, state, outbox);
}

void Commander::handleText(TimePoint, std::uint8_t severity, const std::string &text)
{
    if (severity > mavlink::MAV_SEVERITY_NOTICE || text.empty())
        return;
    for (Action &action : m_actions) {
        if (action.words.find(text) != std::string::npos || action.words.size() + text.size() > kLongestText)
            continue;
        action.words += (action.words.empty() ? "" : "; ") + text;
        if (action.phase == Phase::Holding)
            finish(action, CommandOutcome::Refused, commandResultText(action.result));
    }
    forgetDone();
}

void Commander::handleHeartbeat(TimePoint, const VehicleState &state)
{
    for (Action &action : m_actions) {
        if (action.phase == Phase::Holding
            || !(std::holds_alternative<ArmedIs>(action.plan.sign) || std::holds_alternative<ModeIs>(action.plan.sign)))
            continue;
        const bool acknowledged = action.phase == Phase::Watching;
        action.heardSince = acknowledged;
        const bool repeating = action.phase == Phase::Repeating; // nothing but the sign may ever come then
        if (isTrue(action.plan.sign, state) && (acknowledged || repeating || !action.trueBefore))
            finish(action, CommandOutcome::Accepted, {});
    }
    forgetDone();
}

void Commander::handleMissionCurrent(std::uint16_t index)
{
    seen<MissionItemIs>([index](const MissionItemIs &sign) { return sign.index == index; });
}

void Commander::handlePositionTarget(std::int32_t latitude, std::int32_t longitude)
{
    constexpr std::int64_t kNear = 100; // 1e-7 degrees: a metre, since vehicles convert to metres and back
    seen<TargetIs>([&](const TargetIs &sign) {
        return std::abs(std::int64_t{sign.latitude} - latitude) <= kNear
            && std::abs(std::int64_t{sign.longitude} - longitude) <= kNear;
    });
}

void Commander::handleDeadline(TimePoint now, const VehicleState &state, MessageQueue &outbox)
{
    m_client.handleDeadline(now, outbox);
    takeAnswers(now, state, outbox);
    for (Action &action : m_actions) {
        if (action.done || now < action.deadline)
            continue;
        switch (action.phase) {
        case Phase::Asking: break; // the client's deadline
        case Phase::Repeating: repeat(now, action, outbox); break;
        case Phase::Watching: watchEnded(now, action, state, outbox); break;
        case Phase::Holding: finish(action, CommandOutcome::Refused, commandResultText(action.result)); break;
        }
    }
    takeAnswers(now, state, outbox); // asking again may have been refused at once
}

TimePoint Commander::nextDeadline() const
{
    TimePoint next = m_client.nextDeadline();
    for (const Action &action : m_actions)
        next = std::min(next, action.deadline);
    return next;
}

std::optional<CommandResult> Commander::poll()
{
    if (m_results.empty())
        return std::nullopt;
    CommandResult result = std::move(m_results.front());
    m_results.pop_front();
    return result;
}

void Commander::startWay(TimePoint now, Action &action, MessageQueue &outbox)
{
    action.ticket.reset();
    action.repeats = 0;
    action.deadline = kNever;
    const Way &way = action.plan.ways[action.way];
    if (const auto *order = std::get_if<CommandOrder>(&way)) {
        action.phase = Phase::Asking;
        action.ticket = m_client.send(now, *order, action.plan.replaces, outbox);
    } else {
        action.phase = Phase::Repeating;
        repeat(now, action, outbox);
    }
}

void Commander::repeat(TimePoint now, Action &action, MessageQueue &outbox)
{
    const auto &message = std::get<RepeatedMessage>(action.plan.ways[action.way]);
    if (action.repeats < kRepeats) {
        ++action.repeats;
        action.deadline = now + kRepeatInterval;
        outbox.push(message.message);
    } else if (message.signExpected) {
        nextWay(now, action, CommandOutcome::TimedOut, "no answer to " + std::to_string(kRepeats) + " attempts", outbox);
    } else {
        finish(action, CommandOutcome::Accepted,
               "sent " + std::to_string(kRepeats) + " times; the vehicle does not confirm it");
    }
}

void Commander::nextWay(TimePoint now, Action &action, CommandOutcome otherwise, std::string reason, MessageQueue &outbox)
{
    if (action.way + 1 < action.plan.ways.size()) {
        ++action.way;
        startWay(now, action, outbox);
    } else {
        finish(action, otherwise, std::move(reason));
    }
}

void Commander::takeAnswers(TimePoint now, const VehicleState &state, MessageQueue &outbox)
{
    while (const auto answer = m_client.poll()) {
        const auto action = std::find_if(m_actions.begin(), m_actions.end(),
                                         [&](const Action &candidate) { return candidate.ticket == answer->ticket; });
        if (action == m_actions.end() || action->done)
            continue;
        action->ticket.reset();
        switch (answer->kind) {
        case CommandAnswer::Kind::Answered: answered(now, *action, answer->result, state, outbox); break;
        case CommandAnswer::Kind::TimedOut:
            nextWay(now, *action, CommandOutcome::TimedOut,
                    "no answer to " + std::to_string(CommandClient::kAttempts) + " attempts", outbox);
            break;
        case CommandAnswer::Kind::Replaced: finish(*action, CommandOutcome::Refused, "replaced by a newer command"); break;
        }
    }
    forgetDone();
}

void Commander::answered(TimePoint now, Action &action, std::uint8_t result, const VehicleState &state, MessageQueue &outbox)
{
    action.result = result;
    if (result == mavlink::MAV_RESULT_ACCEPTED) {
        if (!comesWithHeartbeats(action.plan.sign, state)) {
            finish(action, CommandOutcome::Accepted, {});
            return;
        }
        action.phase = Phase::Watching;
        action.heardSince = false;
        action.deadline = now + kWatch;
        return;
    }
    const bool otherWayMayHelp = result == mavlink::MAV_RESULT_UNSUPPORTED || result == mavlink::MAV_RESULT_COMMAND_LONG_ONLY
        || result == mavlink::MAV_RESULT_COMMAND_INT_ONLY || result == mavlink::MAV_RESULT_COMMAND_UNSUPPORTED_MAV_FRAME;
    if (otherWayMayHelp && action.way + 1 < action.plan.ways.size()) {
        nextWay(now, action, CommandOutcome::Refused, {}, outbox);
    } else if (!action.words.empty()) {
        finish(action, CommandOutcome::Refused, commandResultText(result));
    } else {
        action.phase = Phase::Holding;
        action.deadline = now + kHold;
    }
}

void Commander::watchEnded(TimePoint now, Action &action, const VehicleState &state, MessageQueue &outbox)
{
    if (!action.heardSince) {
        finish(action, CommandOutcome::Accepted, "acknowledged; no heartbeat came since");
    } else if (action.mayAskAgain) {
        action.mayAskAgain = false;
        startWay(now, action, outbox);
    } else {
        finish(action, CommandOutcome::TimedOut,
               "acknowledged, but the vehicle reports " + whatItReports(action.plan.sign, state));
    }
}

template<typename T, typename Predicate> void Commander::seen(Predicate matches)
{
    for (Action &action : m_actions) {
        const T *sign = std::get_if<T>(&action.plan.sign);
        if (sign && action.phase == Phase::Repeating && matches(*sign))
            finish(action, CommandOutcome::Accepted, {});
    }
    forgetDone();
}

void Commander::finish(Action &action, CommandOutcome outcome, std::string reason)
{
    if (action.done)
        return;
    if (outcome == CommandOutcome::Refused && !action.words.empty())
        reason += ": " + action.words;
    const bool unanswered = outcome == CommandOutcome::TimedOut && action.result == 0 && action.phase != Phase::Watching;
    m_results.push_back({action.id, m_addressing.system, outcome, action.result, std::move(reason), unanswered});
    action.done = true;
    action.deadline = kNever;
}

void Commander::forgetDone()
{
    std::erase_if(m_actions, [](const Action &action) { return action.done; });
}

} // namespace skyseal::vehicle
