// The flight that a sweep repeats: a flight script (core/vehicle/flight_script.h), divided into the legs that lead to each
// phase in which the arms are measured, and the landing. Plain value.
#pragma once

#include "core/vehicle/flight_script.h"

namespace skyseal::experiment {

struct FlightPlan
{
    std::string script; ///< as written; empty: no flight
    /// One leg to each phase, in their order, and at last the landing, which may be empty. Empty without a flight.
    std::vector<std::vector<vehicle::FlightStep>> legs;

    bool exists() const { return !legs.empty(); }
    /// Phases of one flight: in each of them every arm is measured once. 1 without a flight, of which the ground is the phase.
    unsigned phases() const { return exists() ? static_cast<unsigned>(legs.size()) - 1 : 1; }
};

/// Each '|' between two steps marks a phase. Without one, the only phase is before the first step that lands (land, rtl,
/// disarm, mode LAND, mode RTL), or at the end of a script that does not land. The error is that of parseFlightScript(), or
/// names a phase to which no step leads.
Result<FlightPlan, InputError> parseFlightPlan(std::string_view script);

} // namespace skyseal::experiment
