#include "core/experiment/claims_csv.h"

#include "core/experiment/csv.h"

#include <string_view>
#include <utility>

namespace skyseal::experiment {

namespace {

constexpr std::pair<std::string_view, std::string_view> kClaimColumns[] = {
    {"claim", "key of the claim, as in sweep.json"},
    {"finding", "confirmed, refuted, or not decided"},
    {"margin", "0.03: ratios within 3 % are equivalent"},
    {"decidable_margin", "smallest margin above, by which these data would decide the claim; empty if there is none"},
    {"decidable_below", "below this margin, which is smaller, they would decide it as well; empty if there is none"},
    {"first", "suite that is compared; empty for a claim without ratios"},
    {"second", "suite to which it is compared"},
    {"ratio", "the first to the second"},
    {"ci95_low", "lower end of its 95 % interval; the ratio itself of memory, which is a count"},
    {"ci95_high", "upper end of it"},
    {"sweep", "when the sweep began (UTC)"},
    {"seed", "of the order of runs and of the impairment"}};

} // namespace

std::string claimsCsv(const Results &results, const std::vector<Claim> &claims)
{
    std::string out;
    for (const auto &[name, what] : kClaimColumns)
        out += (out.empty() ? "" : ",") + std::string(name);
    out += "\n";
    const std::string time = settingOf(results, "time");
    const std::string origin = "," + (time.empty() ? time : csvText(time)) + "," + std::to_string(results.plan.seed) + "\n";
    for (const Claim &claim : claims) {
        std::string head = std::string(claim.key) + "," + std::string(findingText(claim.finding));
        for (const double margin : {results.plan.margin, claim.decidable, claim.decidableBelow})
            head.append(",").append(csvNumber(margin));
        for (const ClaimRatio &one : claim.ratios) {
            out += head;
            for (const std::string &cell :
                 {one.first, one.second, csvNumber(one.ratio), csvNumber(one.low), csvNumber(one.high)})
                out.append(",").append(cell);
            out += origin;
        }
        if (claim.ratios.empty())
            out.append(head).append(",,,,,").append(origin);
    }
    return out;
}

std::string claimColumnsCsv()
{
    std::string out = "column,unit,description\n";
    for (const auto &[name, what] : kClaimColumns)
        out += std::string(name) + ",," + csvText(std::string(what)) + "\n";
    return out;
}

} // namespace skyseal::experiment
