#include "core/vehicle/commander.h"

#include "core/vehicle/reasons.h"
#include "core/vehicle/result_reason.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace skyseal::vehicle {

namespace {

constexpr std::size_t kMaxTextLength = 300;

bool isInEffect(const Effect &effect, const VehicleState &state)
{
    if (const auto *armed = std::get_if<ArmedIs>(&effect))
        return state.armed == armed->armed;
    if (const auto *mode = std::get_if<ModeIs>(&effect))
        return state.customMode == mode->customMode;
    if (const auto *item = std::get_if<MissionItemIs>(&effect))
        return state.missionCurrent == item->index;
    if (std::holds_alternative<InAir>(effect))
        return state.inAir;
    return false;
}

/// True if the state after a heartbeat shows whether the effect has come.
bool isInHeartbeat(const Effect &effect)
{
    return std::holds_alternative<ArmedIs>(effect) || std::holds_alternative<ModeIs>(effect)
        || std::holds_alternative<InAir>(effect);
}

/// True if an acknowledgement is not enough and a heartbeat has to confirm the effect.
bool needsConfirmation(const Effect &effect, VehicleKind kind)
{
    // PX4 leaves some modes at once (take-off, land), so its acknowledgement has to suffice.
    return std::holds_alternative<ArmedIs>(effect) || (std::holds_alternative<ModeIs>(effect) && !kind.isPx4());
}

/// The message that is being repeated, if it needs a mode.
const NeededMode *neededMode(const CommandPlan &plan, std::size_t alternative)
{
    const auto *message = std::get_if<RepeatedMessage>(&plan.alternatives[alternative]);
    return message && message->mode ? &*message->mode : nullptr;
}

/// Acknowledged, but the vehicle reports another state.
Reason otherState(const Effect &effect, const VehicleState &state)
{
    if (std::holds_alternative<ArmedIs>(effect))
        return state.armed ? reasons::kStillArmed : reasons::kStillDisarmed;
    if (std::holds_alternative<ModeIs>(effect))
        return reasons::kOtherMode(state.mode);
    return reasons::kOtherItem(state.missionCurrent);
}

} // namespace

bool Commander::perform(TimePoint now, RequestId id, const Request &request)
{
    const auto *command = std::get_if<VehicleCommand>(&request);
    if (command)
        begin(now, id, *command);
    return command != nullptr;
}

bool Commander::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    giveUpAfterSleep(now);
    switch (frame.messageId()) {
    case mavlink::CommandAck::kId: {
        const auto ack = unpack<mavlink::CommandAck>(frame);
        if (addressing().isForUs(ack.target_system, ack.target_component))
            handleAck(now, ack.command, ack.result);
        return true;
    }
    case mavlink::MissionCurrent::kId: {
        const std::uint16_t index = unpack<mavlink::MissionCurrent>(frame).seq;
        effectReported<MissionItemIs>(now, [&](const MissionItemIs &effect) { return effect.index == index; });
        return false;
    }
    case mavlink::PositionTargetGlobalInt::kId: {
        const auto target = unpack<mavlink::PositionTargetGlobalInt>(frame);
        constexpr std::int64_t kNear = 100; // 1e-7 degrees: about 1 m, since vehicles convert to metres and back
        effectReported<TargetIs>(now, [&](const TargetIs &effect) {
            return std::abs(std::int64_t{effect.latitude} - target.lat_int) <= kNear
                && std::abs(std::int64_t{effect.longitude} - target.lon_int) <= kNear;
        });
        return false;
    }
    default: return false;
    }
}

void Commander::handleHeartbeat(TimePoint now)
{
    for (Action &action : m_actions) {
        if (action.phase == Phase::Repeating)
            followMode(now, action);
        if ((action.phase == Phase::AwaitingReason && !action.effectCounts) || !isInHeartbeat(action.plan.effect))
            continue;
        const bool acknowledged = action.phase == Phase::Confirming;
        action.heartbeatSeen = acknowledged;
        const bool repeating = action.phase == Phase::Repeating; // such messages may get no acknowledgement
        if (isInEffect(action.plan.effect, state()) && (acknowledged || repeating || !action.wasInEffect))
            tookEffect(now, action);
    }
    removeDone();
}

void Commander::handleText(const StatusText &text)
{
    if (text.severity > mavlink::MAV_SEVERITY_NOTICE || text.text.empty())
        return; // informational texts give no reasons
    for (Action &action : m_actions) {
        if (action.texts.find(text.text) != std::string::npos || action.texts.size() + text.text.size() > kMaxTextLength)
            continue;
        action.texts += (action.texts.empty() ? "" : "; ") + text.text;
        if (action.phase == Phase::AwaitingReason && !action.effectCounts)
            finish(action, CommandOutcome::Refused, commandResultReason(action.result));
    }
    removeDone();
}

void Commander::handleDeadline(TimePoint now)
{
    giveUpAfterSleep(now);
    m_client.handleDeadline(now);
    takeAnswers(now);
    for (Action &action : m_actions) {
        if (action.done || now < action.deadline)
            continue;
        switch (action.phase) {
        case Phase::Requesting: break; // m_client has the deadline
        case Phase::Repeating: repeat(now, action); break;
        case Phase::Confirming: confirmationTimedOut(now, action); break;
        case Phase::AwaitingReason: finish(action, CommandOutcome::Refused, commandResultReason(action.result)); break;
        }
    }
    takeAnswers(now); // a repeated request may have been refused at once
}

void Commander::giveUpAfterSleep(TimePoint now)
{
    const TimePoint due = nextDeadline();
    if (due == kNever || now - due <= kMostDelay)
        return;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - due).count();
    for (Action &action : m_actions) {
        report(CommandResult{.id = action.id,
                             .systemId = addressing().system,
                             .outcome = CommandOutcome::TimedOut,
                             .reason = reasons::kSuspended(seconds)});
        action.done = true;
    }
    m_client.clear();
    removeDone();
}

TimePoint Commander::nextDeadline() const
{
    TimePoint next = m_client.nextDeadline();
    for (const Action &action : m_actions)
        next = std::min(next, action.deadline);
    return next;
}

void Commander::begin(TimePoint now, RequestId id, const VehicleCommand &command)
{
    auto plan = planCommand(command, state(), addressing());
    Action action;
    action.id = id;
    if (!plan) {
        finish(action, CommandOutcome::Refused, nothingSent(plan.error()));
        return;
    }
    if (m_actions.size() >= kMaxActions) {
        finish(action, CommandOutcome::Refused, nothingSent(reasons::kTooManyCommands));
        return;
    }
    adopt(action, std::move(*plan));
    action.changesMode = changesMode(command);
    action.startsFlight = startsFlight(command);
    if (action.plan.replaces)
        replaceOthers(now, action);
    m_actions.push_back(std::move(action));
    startAlternative(now, m_actions.back());
    takeAnswers(now);
}

/// Takes the plan of a command, or of its next step.
void Commander::adopt(Action &action, CommandPlan plan) const
{
    action.plan = std::move(plan);
    action.alternative = 0;
    action.wasInEffect = isInEffect(action.plan.effect, state());
    action.mayRetry = false;
    action.effectCounts = false;
}

void Commander::replaceOthers(TimePoint now, Action &action)
{
    const auto *armed = std::get_if<ArmedIs>(&action.plan.effect);
    const bool disarms = armed && !armed->armed;
    for (Action &other : m_actions) {
        const bool sameEffect = other.plan.effect.index() == action.plan.effect.index()
            && !std::holds_alternative<std::monostate>(other.plan.effect);
        if (!other.plan.replaces || other.phase == Phase::AwaitingReason
            || !(sameEffect || (action.changesMode && other.changesMode) || (disarms && other.startsFlight)))
            continue;
        if (other.ticket)
            m_client.cancel(now, *other.ticket);
        finish(other, CommandOutcome::Refused, reasons::kReplaced);
        action.mayRetry = action.mayRetry || sameEffect;
    }
    removeDone();
}

void Commander::handleAck(TimePoint now, std::uint16_t command, std::uint8_t result)
{
    if (m_client.handleAck(now, command, result))
        return takeAnswers(now);
    // Some firmware also acknowledges messages, by their message id.
    for (Action &action : m_actions) {
        const auto *message = std::get_if<RepeatedMessage>(&action.plan.alternatives[action.alternative]);
        if (action.phase != Phase::Repeating || !message || result == mavlink::MAV_RESULT_IN_PROGRESS)
            continue;
        // Of a mode, only a heartbeat tells that it was entered.
        const bool refusesMode = action.awaitsMode && message->mode->request.id == command
            && result != mavlink::MAV_RESULT_ACCEPTED;
        if (refusesMode || (!action.awaitsMode && message->message.id == command))
            answered(now, action, result, action.repeats > 1);
    }
    removeDone();
}

void Commander::startAlternative(TimePoint now, Action &action)
{
    action.ticket.reset();
    action.repeats = 0;
    action.deadline = kNever;
    const Alternative &alternative = action.plan.alternatives[action.alternative];
    if (const auto *order = std::get_if<CommandOrder>(&alternative)) {
        action.phase = Phase::Requesting;
        action.ticket = m_client.send(now, *order, action.plan.replaces);
    } else {
        action.phase = Phase::Repeating;
        const NeededMode *mode = neededMode(action.plan, action.alternative);
        action.awaitsMode = mode && state().customMode != mode->customMode;
        action.modeBefore = state().customMode;
        repeat(now, action);
    }
}

/// Sends a message once the mode that it needs is entered. Another mode is someone's will that this command must not undo.
void Commander::followMode(TimePoint now, Action &action)
{
    const NeededMode *mode = neededMode(action.plan, action.alternative);
    if (!mode)
        return;
    const std::uint32_t present = state().customMode;
    if (action.awaitsMode && present == mode->customMode) {
        action.awaitsMode = false;
        action.repeats = 0;
        repeat(now, action);
    } else if (present != (action.awaitsMode ? action.modeBefore : mode->customMode)) {
        finish(action, CommandOutcome::Refused, reasons::kLeftForMode(mode->name, state().mode));
    }
}

void Commander::repeat(TimePoint now, Action &action)
{
    const auto &message = std::get<RepeatedMessage>(action.plan.alternatives[action.alternative]);
    if (action.repeats < kRepeats) {
        ++action.repeats;
        action.deadline = now + kRepeatInterval;
        m_context.outbox.push(action.awaitsMode ? message.mode->request : message.message);
    } else if (action.awaitsMode) {
        nextAlternative(now, action, CommandOutcome::TimedOut, reasons::kStaysInMode(message.mode->name, state().mode));
    } else if (message.effectExpected) {
        nextAlternative(now, action, CommandOutcome::TimedOut, reasons::kNoAnswer(kRepeats));
    } else {
        tookEffect(now, action, reasons::kNotConfirmed(kRepeats));
    }
}

void Commander::nextAlternative(TimePoint now, Action &action, CommandOutcome otherwise, Reason reason)
{
    if (action.alternative + 1 < action.plan.alternatives.size()) {
        ++action.alternative;
        startAlternative(now, action);
    } else {
        finish(action, otherwise, std::move(reason));
    }
}

void Commander::takeAnswers(TimePoint now)
{
    while (const auto answer = m_client.poll()) {
        const auto action = std::find_if(m_actions.begin(), m_actions.end(),
                                         [&](const Action &candidate) { return candidate.ticket == answer->ticket; });
        if (action == m_actions.end() || action->done)
            continue;
        action->ticket.reset();
        switch (answer->kind) {
        case CommandAnswer::Kind::Answered: answered(now, *action, answer->result, answer->repeated); break;
        case CommandAnswer::Kind::TimedOut:
            nextAlternative(now, *action, CommandOutcome::TimedOut, reasons::kNoAnswer(CommandClient::kAttempts));
            break;
        case CommandAnswer::Kind::Replaced: finish(*action, CommandOutcome::Refused, reasons::kReplaced); break;
        }
    }
    removeDone();
}

void Commander::answered(TimePoint now, Action &action, std::uint8_t result, bool repeated)
{
    action.result = result;
    if (result == mavlink::MAV_RESULT_ACCEPTED) {
        if (!needsConfirmation(action.plan.effect, kind())) {
            tookEffect(now, action);
            return;
        }
        action.phase = Phase::Confirming;
        action.heartbeatSeen = false;
        action.deadline = now + kConfirmTimeout;
        return;
    }
    const bool tryNext = result == mavlink::MAV_RESULT_UNSUPPORTED || result == mavlink::MAV_RESULT_COMMAND_LONG_ONLY
        || result == mavlink::MAV_RESULT_COMMAND_INT_ONLY || result == mavlink::MAV_RESULT_COMMAND_UNSUPPORTED_MAV_FRAME;
    if (tryNext && action.alternative + 1 < action.plan.alternatives.size()) {
        nextAlternative(now, action, CommandOutcome::Refused, {});
    } else if (repeated && !action.wasInEffect && !std::holds_alternative<std::monostate>(action.plan.effect)) {
        if (isInEffect(action.plan.effect, state()))
            return tookEffect(now, action);
        action.phase = Phase::AwaitingReason;
        action.effectCounts = true;
        action.deadline = now + kConfirmTimeout;
    } else if (!action.texts.empty()) {
        finish(action, CommandOutcome::Refused, commandResultReason(result));
    } else {
        action.phase = Phase::AwaitingReason;
        action.deadline = now + kReasonTimeout;
    }
}

void Commander::confirmationTimedOut(TimePoint now, Action &action)
{
    if (!action.heartbeatSeen) {
        tookEffect(now, action, reasons::kNoHeartbeat);
    } else if (action.mayRetry) {
        action.mayRetry = false;
        startAlternative(now, action);
    } else {
        finish(action, CommandOutcome::TimedOut, otherState(action.plan.effect, state()));
    }
}

template<typename T, typename Predicate> void Commander::effectReported(TimePoint now, Predicate matches)
{
    for (Action &action : m_actions) {
        const T *effect = std::get_if<T>(&action.plan.effect);
        const bool repeating = action.phase == Phase::Repeating && !action.awaitsMode;
        if (effect && (repeating || action.effectCounts) && matches(*effect))
            tookEffect(now, action);
    }
    removeDone();
}

/// The step under way was carried out; `reason`: what is left in doubt, which must not be when another step depends on it.
void Commander::tookEffect(TimePoint now, Action &action, Reason reason)
{
    if (!action.plan.then)
        return finish(action, CommandOutcome::Accepted, std::move(reason));
    if (action.ticket) // a heartbeat was faster than the acknowledgement
        m_client.cancel(now, *action.ticket);
    if (!reason.empty())
        return finish(action, CommandOutcome::TimedOut, std::move(reason));
    const VehicleCommand command = *std::exchange(action.plan.then, std::nullopt);
    auto plan = planCommand(command, state(), addressing());
    if (!plan)
        return finish(action, CommandOutcome::Refused, plan.error());
    if (++action.prepared == kMostPrepared && plan->then)
        return finish(action, CommandOutcome::Refused, reasons::kNotReady(state().mode));
    action.texts.clear();
    adopt(action, std::move(*plan));
    startAlternative(now, action);
}

/// The reason why a command failed, with the step at which it did.
Reason Commander::withStep(const Action &action, Reason reason) const
{
    if (action.plan.then) {
        if (const auto *mode = std::get_if<ModeIs>(&action.plan.effect))
            return reasons::kFailedInMode(mode->name, std::move(reason));
        return reasons::kFailedToArm(std::move(reason));
    }
    return action.prepared > 0 && state().armed ? reasons::kFailedArmed(std::move(reason)) : reason;
}

void Commander::finish(Action &action, CommandOutcome outcome, Reason reason)
{
    if (action.done)
        return;
    if (outcome == CommandOutcome::Refused && !action.texts.empty())
        reason = reasons::kWithTexts(std::move(reason), action.texts);
    if (outcome == CommandOutcome::Accepted)
        action.result = mavlink::MAV_RESULT_ACCEPTED; // whatever the repetition was answered
    else
        reason = withStep(action, std::move(reason));
    const bool unanswered = outcome == CommandOutcome::TimedOut && action.result == 0 && action.phase != Phase::Confirming;
    report(CommandResult{action.id, addressing().system, outcome, action.result, std::move(reason), unanswered});
    action.done = true;
    action.deadline = kNever;
}

void Commander::removeDone()
{
    std::erase_if(m_actions, [](const Action &action) { return action.done; });
}

} // namespace skyseal::vehicle
