// The task of a run without a window: sends requests to a vehicle and evaluates their results.
// The run calls it on its thread, sends its requests, and ends when it has finished.
#pragma once

#include "core/engine/station/event.h"
#include "core/vehicle/request.h"

#include <cstdint>
#include <optional>
#include <string>

namespace skyseal::engine {

struct Snapshot;

struct TaskRequest
{
    std::uint8_t systemId = 0;
    vehicle::Request request;
};

class RunTask
{
public:
    virtual ~RunTask() = default;
    /// Called every 50 ms with the newest snapshot.
    virtual void advance(TimePoint now, const Snapshot &snapshot) = 0;
    virtual void handle(const Event &event) = 0;
    /// The next request to send; requestSent() then passes its id.
    virtual std::optional<TaskRequest> pollRequest() = 0;
    virtual void requestSent(vehicle::RequestId id) = 0;

    virtual bool isFinished() const = 0;
    /// Reason why the goal was not reached, for people; empty if it was.
    virtual const std::string &problem() const = 0;
    /// True if the reason is a file of this machine that could not be written.
    virtual bool isFileProblem() const { return false; }
};

} // namespace skyseal::engine
