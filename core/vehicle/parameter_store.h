// The parameters of a vehicle as far as they are known, by component and name, and the list of them that others see: a new
// object after a change, at most one in kCollectFor, besides the results of requests. A vehicle can invent names without end,
// so their number is bounded. Component 0 is the autopilot, as in Parameter.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/parameter.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

class ParameterStore
{
public:
    /// Names kept of the autopilot, and again of all other components together, so that these cannot take its place.
    static constexpr std::size_t kMostNames = 8192;
    /// Names kept beyond the number that a component announces: a write can make further parameters visible.
    static constexpr std::size_t kNamesBeyondCount = 64;
    /// Changes that answer no write are collected for so long before list() shows them.
    static constexpr Duration kCollectFor = std::chrono::milliseconds(500);
    /// The index in a PARAM_VALUE that answers a write.
    static constexpr std::uint16_t kNoIndex = 65535;

    /// The number of parameters that a component announces.
    void expect(std::uint8_t component, std::uint16_t count) { m_components[component].expected = count; }
    /// The sum over the components.
    std::uint32_t expected() const;

    /// Returns true if something changed.
    bool store(Parameter parameter);
    /// Null if it is not known.
    const Parameter *find(std::uint8_t component, std::string_view name) const;

    /// Sorted by component and name; null before the first parameter.
    std::shared_ptr<const std::vector<Parameter>> list() const;
    /// list() shows all changes from now on.
    void publish(TimePoint now);
    /// After a change: publishes it, at once if `isResult`.
    void publishChange(TimePoint now, bool isResult);
    /// When collected changes are published; kNever without any.
    TimePoint publishDue() const { return m_publishDue; }

private:
    struct OfComponent
    {
        std::map<std::string, Parameter, std::less<>> values{};
        std::uint16_t expected = 0;
    };

    bool mayAddTo(std::uint8_t component) const;

    std::map<std::uint8_t, OfComponent> m_components;
    mutable std::shared_ptr<const std::vector<Parameter>> m_list; ///< built on demand
    TimePoint m_published = TimePoint::min();                     ///< time of the latest change of the list
    TimePoint m_publishDue = kNever;                              ///< there are collected changes
};

} // namespace skyseal::vehicle
