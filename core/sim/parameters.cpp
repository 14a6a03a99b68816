#include "core/sim/parameters.h"

#include <algorithm>
#include <cmath>

namespace skyseal::sim {

Parameters::Parameters(const VehicleType &type) : m_type(type), m_table(&parameterTable(type))
{
    for (const ParameterInfo &info : *m_table)
        m_values.push_back(info.standard);
}

std::optional<std::size_t> Parameters::find(std::string_view name) const
{
    const auto &table = *m_table;
    const auto at = std::lower_bound(table.begin(), table.end(), name,
                                     [](const ParameterInfo &info, std::string_view wanted) { return info.name < wanted; });
    if (at == table.end() || at->name != name)
        return std::nullopt;
    return static_cast<std::size_t>(at - table.begin());
}

float Parameters::value(std::string_view name) const
{
    const auto index = find(name);
    return index ? m_values[*index] : 0;
}

Parameters::SetResult Parameters::set(std::size_t index, float value)
{
    if (index >= m_values.size())
        return SetResult::Unknown;
    const ParameterInfo &parameter = info(index);
    if (!std::isfinite(value))
        return SetResult::NotFinite;
    if (parameter.type != ParameterType::Real32)
        value = std::round(value);
    if (value < parameter.minimum || value > parameter.maximum)
        return SetResult::OutOfRange;
    m_values[index] = value;
    ++m_revision;
    return SetResult::Stored;
}

Parameters::SetResult Parameters::set(std::string_view name, float value)
{
    const auto index = find(name);
    return index ? set(*index, value) : SetResult::Unknown;
}

} // namespace skyseal::sim
