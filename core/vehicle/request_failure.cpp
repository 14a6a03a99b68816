#include "core/vehicle/request_failure.h"

namespace skyseal::vehicle {

namespace {

/// One overload for each kind of request; without one for a new kind, failureOf() does not compile.
struct Failure
{
    RequestId id;
    std::uint8_t systemId;
    std::string reason;

    Event operator()(const VehicleCommand &) const
    {
        return CommandResult{.id = id, .systemId = systemId, .outcome = CommandOutcome::Refused, .reason = reason};
    }
    Event operator()(const ReadParameters &) const { return ParameterResult{.id = id, .systemId = systemId, .reason = reason}; }
    Event operator()(const WriteParameter &request) const
    {
        return ParameterResult{.id = id, .systemId = systemId, .parameter = {.name = request.name}, .reason = reason};
    }
    Event operator()(const ReadMission &request) const { return mission(MissionTransfer::Download, request.type); }
    Event operator()(const WriteMission &request) const { return mission(MissionTransfer::Upload, request.type); }
    Event operator()(const ClearMission &request) const { return mission(MissionTransfer::Clear, request.type); }

    Event mission(MissionTransfer transfer, MissionType type) const
    {
        return MissionResult{.id = id, .systemId = systemId, .transfer = transfer, .type = type, .reason = reason};
    }
};

} // namespace

Event failureOf(RequestId id, std::uint8_t systemId, const Request &request, std::string reason)
{
    return std::visit(Failure{id, systemId, std::move(reason)}, request);
}

} // namespace skyseal::vehicle
