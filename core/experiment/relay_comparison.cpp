#include "core/experiment/relay_comparison.h"

#include "core/experiment/bar_chart.h"
#include "core/experiment/html_parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace skyseal::experiment {

namespace {

std::int64_t countGrowth(std::uint64_t begin, std::uint64_t end)
{
    return static_cast<std::int64_t>(end - begin);
}

std::string sharePercent(double part, double whole)
{
    return whole > 0 ? readable(100 * part / whole) : "–";
}

std::vector<std::string> numberCells(const RelayComparison &compared)
{
    const auto received = static_cast<double>(compared.received), lost = static_cast<double>(compared.lost),
               dropped = static_cast<double>(compared.dropped);
    return {std::string(compared.unit),
            readable(received),
            readable(lost),
            readable(dropped),
            readable(lost - dropped),
            sharePercent(lost, received + lost),
            sharePercent(dropped, received + dropped)};
}

std::string explanation(const Results &results)
{
    std::string out =
        "<p>The sweep's own relay logs each datagram that it drops. Its count of the records in them, or of the frames where "
        "the link carries clear MAVLink, is read at both edges of a run, and stands here beside the loss that the station "
        "measured by its sequence numbers, in the direction of the station. The two may differ by what was in transit at the "
        "edges: the station notices a loss when the next record or frame arrives.";
    if (std::ranges::any_of(results.plan.conditions, [](const Condition &one) { return one.settings.corrupt > 0; }))
        out += " Damaged datagrams are missing at the station as well, and are not in the relay's count.";
    return out + "</p>\n";
}

} // namespace

std::optional<RelayComparison> comparedWithRelay(const Plan &plan, const Sample &sample)
{
    if (!sample.problem.empty() || !sample.begin.relay || !sample.end.relay)
        return std::nullopt;
    const Counted &begin = sample.begin, &end = sample.end;
    const Counted::Dropped &before = begin.relay->toStation, &after = end.relay->toStation;
    const SweepArm &arm = plan.arms[sample.run.arm];
    if (arm.suite != crypto::SuiteId::None && arm.framing != ArmFraming::Bare)
        return RelayComparison{"records", end.rx.good - begin.rx.good, countGrowth(begin.rx.lost, end.rx.lost),
                               countGrowth(before.records, after.records)};
    if (std::isnan(sample.values[Metric::Loss]))
        return std::nullopt;
    const std::uint64_t copies = end.mavlink.duplicate - begin.mavlink.duplicate;
    return RelayComparison{"frames", end.mavlink.taken - begin.mavlink.taken - copies,
                           countGrowth(begin.mavlink.lost, end.mavlink.lost), countGrowth(before.frames, after.frames)};
}

std::string relayTable(const Results &results)
{
    const Plan &plan = results.plan;
    std::string rows;
    RelayComparison records{.unit = "records"}, frames{.unit = "frames"};
    for (const Sample &sample : results.samples) {
        const auto compared = comparedWithRelay(plan, sample);
        if (!compared)
            continue;
        RelayComparison &sum = compared->unit == records.unit ? records : frames;
        sum.received += compared->received;
        sum.lost += compared->lost;
        sum.dropped += compared->dropped;
        const SweepArm &arm = plan.arms[sample.run.arm];
        std::vector<std::string> cells{
            std::to_string(sample.order + 1), escaped(conditionText(plan.conditions[sample.run.condition])),
            std::string(name(plan.loads[sample.run.load])), armText(arm), std::string(framingName(arm))};
        for (std::string &cell : numberCells(*compared))
            cells.push_back(std::move(cell));
        rows += row(cells);
    }
    if (rows.empty())
        return rows;
    for (const RelayComparison &sum : {records, frames}) {
        if (sum.received == 0)
            continue;
        std::vector<std::string> cells{"all", "", "", "", ""};
        for (const std::string &cell : numberCells(sum))
            cells.push_back("<b>" + cell + "</b>");
        rows += row(cells);
    }
    return explanation(results) + "<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n"
        + headOfTable({{"run", "link", "load", "suite", "framing", "unit", "received", "lost, measured", "dropped by the relay",
                        "difference", "lost, %", "dropped, %"}})
        + rows + "</table>\n";
}

} // namespace skyseal::experiment
