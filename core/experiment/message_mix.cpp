#include "core/experiment/message_mix.h"

#include "core/experiment/contrast.h"
#include "core/mavlink/dialect.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace skyseal::experiment {

namespace {

using MixCounts = std::map<std::uint32_t, std::uint64_t>;

std::string messageName(std::uint32_t id)
{
    const mavlink::MessageInfo *known = mavlink::Dialect::builtin().find(id);
    return known ? std::string(known->name) : "message " + std::to_string(id);
}

MixCounts countsOf(const Results &results, std::size_t load, std::size_t arm)
{
    MixCounts out;
    for (const Sample &sample : results.samples) {
        if (sample.run.load != load || sample.run.arm != arm || !sample.isValid())
            continue;
        for (const auto &[id, frames] : sample.messages)
            out[id] += frames;
    }
    return out;
}

} // namespace

MessageMix messageMixOf(const Results &results, std::size_t load)
{
    MixCounts counts;
    if (const auto reference = referenceArm(results.plan))
        counts = countsOf(results, load, *reference);
    for (std::size_t arm = 0; arm < results.plan.arms.size() && counts.empty(); ++arm)
        counts = countsOf(results, load, arm);
    std::uint64_t all = 0;
    for (const auto &[id, frames] : counts)
        all += frames;
    MessageMix out;
    for (const auto &[id, frames] : counts) {
        if (frames > 0)
            out[id] = static_cast<double>(frames) / static_cast<double>(all);
    }
    return out;
}

std::string messageMixText(const MessageMix &mix)
{
    constexpr double kLeast = 0.01;
    std::vector<std::pair<std::uint32_t, double>> sorted(mix.begin(), mix.end());
    std::ranges::stable_sort(sorted, [](const auto &one, const auto &two) { return one.second > two.second; });
    std::string out;
    double rest = 0;
    std::size_t others = 0;
    for (const auto &[id, share] : sorted) {
        if (share >= kLeast) {
            out += (out.empty() ? "" : ", ") + messageName(id) + " " + percentText(share);
            continue;
        }
        rest += share;
        ++others;
    }
    if (others > 0)
        out += (out.empty() ? "" : ", ") + std::to_string(others) + (others == 1 ? " other " : " others ") + percentText(rest);
    return out;
}

std::string mixDifference(const Results &one, const std::string &oneName, const Results &two, const std::string &twoName)
{
    const std::size_t loads = std::min(one.plan.loads.size(), two.plan.loads.size());
    for (std::size_t load = 0; load < loads; ++load) {
        if (one.plan.loads[load] == Load::Saturated)
            continue;
        const MessageMix first = messageMixOf(one, load), second = messageMixOf(two, load);
        if (first.empty() || second.empty())
            continue;
        MessageMix all = first;
        all.insert(second.begin(), second.end());
        const auto shareIn = [](const MessageMix &mix, std::uint32_t id) {
            const auto found = mix.find(id);
            return found == mix.end() ? 0.0 : found->second;
        };
        const auto gap = [&](const auto &entry) {
            return std::abs(shareIn(first, entry.first) - shareIn(second, entry.first));
        };
        const auto widest = std::ranges::max_element(all, {}, gap);
        if (gap(*widest) > kMixTolerance) {
            std::string text = "under the ";
            text.append(name(one.plan.loads[load])).append(" load ");
            text.append(percentText(shareIn(first, widest->first))).append(" of the frames of ").append(oneName);
            text.append(" are ").append(messageName(widest->first)).append(", and ");
            text.append(percentText(shareIn(second, widest->first))).append(" of those of ").append(twoName);
            text.append(", more than ").append(readable(100 * kMixTolerance)).append(" percentage points apart");
            return text;
        }
    }
    return {};
}

} // namespace skyseal::experiment
