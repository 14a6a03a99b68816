#include "core/experiment/block_model.h"

#include "core/experiment/statistics.h"

#include <map>
#include <set>
#include <utility>

namespace skyseal::experiment {

/// One launch: its values in rows of blocks. Several: the arms' effects within each, in rows of launches. Arms that no block
/// joins within a launch are in rows of their own, as they cannot be compared there.
BlockModel::Reduced BlockModel::reduced(const std::vector<BlockValue> &values, std::size_t arms)
{
    std::map<std::size_t, std::vector<TwoWayValue>> launches;
    for (const BlockValue &one : values)
        launches[one.launch].push_back({one.block, one.arm, one.value});
    Reduced out;
    out.launches = launches.size();
    if (launches.size() == 1) {
        out.values = launches.begin()->second;
        return out;
    }
    std::size_t place = 0;
    for (const auto &[number, inLaunch] : launches) {
        const TwoWayFit fit(inLaunch, arms);
        for (std::size_t arm = 0; arm < arms; ++arm) {
            if (fit.has(arm))
                out.values.push_back({place * arms + fit.groupOf(arm), arm, fit.effect(arm)});
        }
        ++place;
    }
    return out;
}

BlockModel::BlockModel(const std::vector<BlockValue> &values, std::size_t arms) : BlockModel(reduced(values, arms), arms) {}

BlockModel::BlockModel(Reduced reduced, std::size_t arms)
    : m_values(std::move(reduced.values)), m_launches(reduced.launches), m_fit(m_values, arms)
{}

BlockContrast BlockModel::contrast(std::size_t first, std::size_t second) const
{
    if (!m_fit.comparable(first, second))
        return {kNaN, kNaN, kNaN, 0};
    std::set<std::size_t> one, both;
    for (const TwoWayValue &value : m_values) {
        if (value.column == first)
            one.insert(value.row);
    }
    for (const TwoWayValue &value : m_values) {
        if (value.column == second && one.contains(value.row))
            both.insert(value.row);
    }
    const TwoWayContrast fitted = m_fit.contrast(first, second);
    return {fitted.estimate, fitted.error, m_fit.degrees(), both.size()};
}

} // namespace skyseal::experiment
