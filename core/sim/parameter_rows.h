// Rows of the parameter tables, by what they belong to.
#pragma once

#include "core/sim/parameter_table.h"

#include <span>

namespace skyseal::sim {

struct ParameterRow
{
    const char *name;
    ParameterType type;
    float standard, minimum, maximum;
};

/// The faults, the wind and the clock of the simulation: every vehicle has them.
std::span<const ParameterRow> simulationRows();
/// Of every vehicle of ArduPilot.
std::span<const ParameterRow> arduPilotRows();
std::span<const ParameterRow> copterRows();
std::span<const ParameterRow> planeRows();
std::span<const ParameterRow> roverRows();
std::span<const ParameterRow> px4Rows();

} // namespace skyseal::sim
