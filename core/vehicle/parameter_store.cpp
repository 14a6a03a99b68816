#include "core/vehicle/parameter_store.h"

#include <algorithm>
#include <utility>

namespace skyseal::vehicle {

std::uint32_t ParameterStore::expected() const
{
    std::uint32_t sum = 0;
    for (const auto &[number, component] : m_components)
        sum += component.expected;
    return sum;
}

bool ParameterStore::store(Parameter parameter)
{
    auto &values = m_components[parameter.componentId].values;
    const auto known = values.find(parameter.name);
    if (known == values.end()) {
        if (!mayAddTo(parameter.componentId))
            return false;
        values.emplace(parameter.name, parameter);
        return true;
    }
    if (parameter.index == kNoIndex)
        parameter.index = known->second.index;
    if (known->second.value == parameter.value && known->second.type == parameter.type
        && known->second.index == parameter.index)
        return false;
    known->second = std::move(parameter);
    return true;
}

bool ParameterStore::mayAddTo(std::uint8_t component) const
{
    const OfComponent &own = m_components.at(component);
    std::size_t beside = 0;
    for (const auto &[number, other] : m_components)
        beside += component != 0 && number != 0 && number != component ? other.values.size() : 0;
    return own.values.size() < own.expected + kNamesBeyondCount && own.values.size() + beside < kMostNames;
}

const Parameter *ParameterStore::find(std::uint8_t component, std::string_view name) const
{
    const auto of = m_components.find(component);
    if (of == m_components.end())
        return nullptr;
    const auto known = of->second.values.find(name);
    return known == of->second.values.end() ? nullptr : &known->second;
}

std::shared_ptr<const std::vector<Parameter>> ParameterStore::list() const
{
    std::size_t size = 0;
    for (const auto &[number, component] : m_components)
        size += component.values.size();
    if (!m_list && size > 0) {
        auto list = std::make_shared<std::vector<Parameter>>();
        list->reserve(size);
        for (const auto &[number, component] : m_components) {
            for (const auto &[name, parameter] : component.values)
                list->push_back(parameter);
        }
        m_list = std::move(list);
    }
    return m_list;
}

void ParameterStore::publish(TimePoint now)
{
    m_list.reset();
    m_published = now;
    m_publishDue = kNever;
}

void ParameterStore::publishChange(TimePoint now, bool isResult)
{
    if (isResult || m_published == TimePoint::min() || now >= m_published + kCollectFor)
        publish(now);
    else
        m_publishDue = m_published + kCollectFor;
}

} // namespace skyseal::vehicle
