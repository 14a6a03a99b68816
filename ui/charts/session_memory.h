// The memory of a session under each suite, measured once per suite when it is first used.
#pragma once

#include "core/experiment/cipher_bench.h"

#include <functional>
#include <limits>
#include <map>

namespace skyseal::ui {

class SessionMemory
{
public:
    using Measure = std::function<std::optional<double>(crypto::SuiteId)>;

    explicit SessionMemory(Measure measure = experiment::sessionBytes) : m_measure(std::move(measure)) {}

    /// Returns the heap in bytes; NaN without a session, or if it cannot be measured.
    double of(crypto::SuiteId suite)
    {
        const auto [place, isNew] = m_known.try_emplace(suite, std::numeric_limits<double>::quiet_NaN());
        if (isNew && suite != crypto::SuiteId::None)
            place->second = m_measure(suite).value_or(place->second);
        return place->second;
    }

private:
    Measure m_measure;
    std::map<crypto::SuiteId, double> m_known;
};

} // namespace skyseal::ui
