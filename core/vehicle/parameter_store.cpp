#include "core/vehicle/parameter_store.h"

#include <algorithm>
#include <utility>

namespace skyseal::vehicle {

bool ParameterStore::store(Parameter parameter)
{
    const auto known = m_values.find(parameter.name);
    if (known == m_values.end()) {
        if (!mayAdd())
            return false;
        m_values.emplace(parameter.name, parameter);
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

bool ParameterStore::mayAdd() const
{
    return m_values.size() < std::min(kMostNames, m_expected + kNamesBeyondCount);
}

const Parameter *ParameterStore::find(std::string_view name) const
{
    const auto known = m_values.find(name);
    return known == m_values.end() ? nullptr : &known->second;
}

std::shared_ptr<const std::vector<Parameter>> ParameterStore::list() const
{
    if (!m_list && !m_values.empty()) {
        auto list = std::make_shared<std::vector<Parameter>>();
        list->reserve(m_values.size());
        for (const auto &entry : m_values)
            list->push_back(entry.second);
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
