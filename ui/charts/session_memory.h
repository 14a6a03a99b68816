// What a session's memory is under each suite, asked for once for each, when it is used for the first time.
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

    /// Bytes of the heap; NaN without a session, and where the system does not tell.
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
