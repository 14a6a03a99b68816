#include "core/vehicle/unanswered_requests.h"

#include "core/vehicle/reasons.h"
#include "core/vehicle/request_failure.h"

#include <utility>

namespace skyseal::vehicle {

namespace {

bool isListRead(const Event &failure)
{
    const auto *parameter = std::get_if<ParameterResult>(&failure);
    return parameter && parameter->action == ParameterAction::ReadList;
}

} // namespace

void UnansweredRequests::note(RequestId id, std::uint8_t systemId, const Request &request)
{
    if (std::holds_alternative<CancelTransfer>(request))
        return;                                          // has no result
    if (std::holds_alternative<ReadParameters>(request)) // the one that it replaces has no result either
        std::erase_if(m_failures, [](const auto &entry) { return isListRead(entry.second); });
    m_failures.insert_or_assign(id, failureOf(id, systemId, request, reasons::kOtherAutopilot));
}

void UnansweredRequests::handle(const Event &event)
{
    std::visit(
        [this](const auto &result) {
            if constexpr (requires { result.id; })
                m_failures.erase(result.id);
        },
        event);
}

void UnansweredRequests::fail(std::deque<Event> &events)
{
    for (auto &[id, failure] : std::exchange(m_failures, {}))
        events.push_back(std::move(failure));
}

} // namespace skyseal::vehicle
