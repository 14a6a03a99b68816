// The names under which one vehicle's values are known outside: the monitor writes its statistics and a flight script reads
// its conditions from this one table, so that both always mean the same thing.
#pragma once

#include "core/base/json_writer.h"
#include "core/vehicle/vehicle_state.h"

#include <span>
#include <string>
#include <string_view>

namespace skyseal::vehicle {

struct StateField
{
    enum class Kind : std::uint8_t { Number, Integer, Flag, Text };

    std::string_view name;
    std::string_view unit; ///< empty for none
    Kind kind{};
    double (*number)(const VehicleState &) = nullptr;           ///< NaN = unknown; of Flag 0 or 1; null for Text
    const std::string &(*text)(const VehicleState &) = nullptr; ///< only for Text
};

/// In the order in which they are written.
std::span<const StateField> stateFields();
/// Null when there is none of this name.
const StateField *findStateField(std::string_view name);

/// Writes all fields as members of the open object, and the batteries as an array; unknown values as null.
void writeStateFields(JsonWriter &json, const VehicleState &state);

} // namespace skyseal::vehicle
