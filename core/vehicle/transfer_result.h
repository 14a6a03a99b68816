// How the longer conversations with a vehicle ended.
#pragma once

#include "core/vehicle/parameter.h"

#include <cstdint>
#include <string>

namespace skyseal::vehicle {

enum class MissionTransfer : std::uint8_t { Upload, Download, Clear };

struct MissionResult
{
    MissionTransfer transfer{};
    bool ok = false;
    std::string reason; ///< in words, when not ok
    bool unanswered = false;
};

struct ParameterResult
{
    Parameter parameter; ///< with the value that the vehicle has now, where it said so
    bool ok = false;
    std::string reason;
    bool unanswered = false;
};

} // namespace skyseal::vehicle
