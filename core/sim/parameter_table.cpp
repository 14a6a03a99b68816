#include "core/sim/parameter_table.h"

#include "core/sim/parameter_rows.h"

#include <algorithm>
#include <array>

namespace skyseal::sim {

namespace {

using enum ParameterType;

using Table = std::vector<ParameterInfo>;

void append(Table &table, std::span<const ParameterRow> rows)
{
    for (const ParameterRow &row : rows)
        table.push_back({row.name, row.type, row.standard, row.minimum, row.maximum});
}

/// Of the transmitter's and the servos' channels; `modes`: on the six positions of the mode switch.
void appendChannels(Table &table, const char *modePrefix, const std::array<float, 6> &modes)
{
    for (int i = 0; i < 6; ++i)
        table.push_back({modePrefix + std::to_string(i + 1), Int8, modes[static_cast<std::size_t>(i)], 0, 28});
    for (int i = 1; i <= 8; ++i) {
        const std::string channel = "RC" + std::to_string(i) + "_";
        table.push_back({channel + "MIN", Int16, 1000, 800, 2200});
        table.push_back({channel + "MAX", Int16, 2000, 800, 2200});
        table.push_back({channel + "TRIM", Int16, i == 3 ? 1000.f : 1500.f, 800, 2200});
        table.push_back({channel + "DZ", Int16, i <= 2 ? 20.f : i == 3 ? 30.f : i == 4 ? 20.f : 0.f, 0, 200});
        table.push_back({channel + "REVERSED", Int8, 0, 0, 1});
        table.push_back({channel + "OPTION", Int16, 0, 0, 400});
        const std::string output = "SERVO" + std::to_string(i) + "_";
        table.push_back({output + "MIN", Int16, 1000, 500, 2200});
        table.push_back({output + "MAX", Int16, 2000, 800, 2200});
        table.push_back({output + "TRIM", Int16, 1500, 800, 2200});
        table.push_back({output + "FUNCTION", Int16, i <= 4 ? static_cast<float>(32 + i) : 0.f, -1, 189});
        table.push_back({output + "REVERSED", Int8, 0, 0, 1});
    }
}

Table build(const VehicleType &type)
{
    Table table;
    append(table, simulationRows());
    if (type.isPx4()) {
        append(table, px4Rows());
    } else {
        append(table, arduPilotRows());
        switch (type.kind) {
        case CraftKind::Copter: // stabilize, altitude hold, loiter, RTL, land, guided
            append(table, copterRows());
            appendChannels(table, "FLTMODE", {0, 2, 5, 6, 9, 4});
            break;
        case CraftKind::Plane: // RTL, RTL, fly-by-wire A twice, manual twice
            append(table, planeRows());
            appendChannels(table, "FLTMODE", {11, 11, 5, 5, 0, 0});
            break;
        case CraftKind::Rover: // manual
            append(table, roverRows());
            appendChannels(table, "MODE", {0, 0, 0, 0, 0, 0});
            break;
        }
    }
    std::sort(table.begin(), table.end(), [](const ParameterInfo &a, const ParameterInfo &b) { return a.name < b.name; });
    return table;
}

} // namespace

const std::vector<ParameterInfo> &parameterTable(const VehicleType &type)
{
    static const Table copter = build({CraftKind::Copter}), plane = build({CraftKind::Plane}),
                       rover = build({CraftKind::Rover}), px4 = build({CraftKind::Copter, Firmware::Px4});
    if (type.isPx4())
        return px4;
    return type.kind == CraftKind::Plane ? plane : type.isRover() ? rover : copter;
}

} // namespace skyseal::sim
