#include "core/vehicle/request_failure.h"

namespace skyseal::vehicle {

namespace {

/// One overload for each kind of request; without one for a new kind, failureOf() does not compile.
struct Failure
{
    RequestId id;
    std::uint8_t systemId;
    Reason reason;

    Event operator()(const VehicleCommand &) const
    {
        return CommandResult{.id = id, .systemId = systemId, .outcome = CommandOutcome::Refused, .reason = reason};
    }
    Event operator()(const ReadParameters &) const { return parameter({}, 0, ParameterAction::ReadList); }
    Event operator()(const ReadParameter &request) const
    {
        return parameter(request.name, request.componentId, ParameterAction::Read);
    }
    Event operator()(const WriteParameter &request) const
    {
        return parameter(request.name, request.componentId, ParameterAction::Write);
    }
    Event operator()(const ReadMission &request) const { return mission(MissionTransfer::Download, request.type); }
    Event operator()(const WriteMission &request) const { return mission(MissionTransfer::Upload, request.type); }
    Event operator()(const ClearMission &request) const { return mission(MissionTransfer::Clear, request.type); }

    Event operator()(const ListFolder &request) const { return file(request.path, FileAction::List); }
    Event operator()(const ReadFile &request) const { return file(request.path, FileAction::Read); }
    Event operator()(const WriteFile &request) const { return file(request.path, FileAction::Write); }
    Event operator()(const RemoveFile &request) const { return file(request.path, FileAction::Remove); }
    Event operator()(const ListLogs &) const { return log(0, LogAction::List); }
    Event operator()(const ReadLog &request) const { return log(request.log, LogAction::Read); }
    Event operator()(const EraseLogs &) const { return log(0, LogAction::Erase); }
    Event operator()(const CancelTransfer &) const { return file({}, FileAction::Read); }

    Event parameter(const std::string &name, std::uint8_t component, ParameterAction action) const
    {
        return ParameterResult{.id = id,
                               .systemId = systemId,
                               .parameter = {.name = name, .componentId = component},
                               .reason = reason,
                               .action = action};
    }
    Event file(const std::string &path, FileAction action) const
    {
        return FileResult{.id = id, .systemId = systemId, .action = action, .path = path, .reason = reason};
    }
    Event log(std::uint16_t number, LogAction action) const
    {
        return LogResult{.id = id, .systemId = systemId, .action = action, .log = number, .reason = reason};
    }
    Event mission(MissionTransfer transfer, MissionType type) const
    {
        return MissionResult{.id = id, .systemId = systemId, .transfer = transfer, .type = type, .reason = reason};
    }
};

} // namespace

Event failureOf(RequestId id, std::uint8_t systemId, const Request &request, Reason reason)
{
    return std::visit(Failure{id, systemId, std::move(reason)}, request);
}

} // namespace skyseal::vehicle
