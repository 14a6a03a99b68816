// The values of one vehicle's parameters.
#pragma once

#include "core/sim/parameter_table.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace skyseal::sim {

class Parameters
{
public:
    explicit Parameters(const VehicleType &type = {});

    const VehicleType &type() const { return m_type; }

    std::size_t count() const { return m_values.size(); }
    std::optional<std::size_t> find(std::string_view name) const;
    const ParameterInfo &info(std::size_t index) const { return (*m_table)[index]; }

    float value(std::size_t index) const { return m_values[index]; }
    /// The value of a parameter; 0 for a name that is not in the table.
    float value(std::string_view name) const;
    int integer(std::string_view name) const { return static_cast<int>(value(name)); }
    bool flag(std::string_view name) const { return value(name) != 0; }

    enum class SetResult { Stored, Unknown, NotFinite, OutOfRange };
    /// Stores a value, rounded if the type is an integer. A value that is refused changes nothing.
    SetResult set(std::size_t index, float value);
    SetResult set(std::string_view name, float value);

    /// The parameter that holds the system id.
    const char *systemIdName() const { return m_type.isPx4() ? "MAV_SYS_ID" : "SYSID_THISMAV"; }
    /// Whether a station may hold the sticks: ArduPilot knows one, PX4 takes any.
    bool isPilot(std::uint8_t systemId) const { return m_type.isPx4() || systemId == integer("SYSID_MYGCS"); }

    /// Rises with every stored value, so that holders of copies detect a change.
    unsigned revision() const { return m_revision; }

private:
    VehicleType m_type;
    const std::vector<ParameterInfo> *m_table;
    std::vector<float> m_values;
    unsigned m_revision = 0;
};

} // namespace skyseal::sim
