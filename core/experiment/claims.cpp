#include "core/experiment/claims.h"

#include "core/base/number_text.h"
#include "core/experiment/analysis.h"
#include "core/experiment/contrast.h"
#include "core/experiment/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ranges>
#include <tuple>
#include <utility>

namespace skyseal::experiment {

namespace {

using crypto::SuiteId;

constexpr std::array kOthers{SuiteId::Aes256Cbc, SuiteId::Aes256Ctr, SuiteId::Rc4};
constexpr std::array kPapers{SuiteId::ChaCha20, SuiteId::Aes256Ctr, SuiteId::Aes256Cbc, SuiteId::Rc4};

std::string nameOf(SuiteId suite)
{
    return std::string(crypto::suiteInfo(suite).name);
}

/// The framing that the claims are judged in.
ArmFraming judgedFraming(const Plan &plan)
{
    std::vector<ArmFraming> framings = framingsOf(plan);
    if (framings.size() > 1)
        std::erase(framings, ArmFraming::Bare); // of which there are two ciphers only
    return framings.empty() ? ArmFraming::Sealed : framings.back();
}

/// Where a claim is judged.
struct Place
{
    std::size_t condition = 0, load = 0;
};

struct Pair
{
    SuiteId first, second;
};

/// The load that claims by this metric speak of: that of an autopilot for costs, but a saturated one for packets, since the
/// vehicle decides their number under any other.
Load loadOf(Metric metric)
{
    return info(metric).setByVehicle ? Load::Saturated : Load::Natural;
}

std::optional<std::size_t> judgedArm(const Plan &plan, SuiteId suite)
{
    for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
        const SweepArm &one = plan.arms[arm];
        if (one.suite == suite && !one.again && (suite == SuiteId::None || one.framing == judgedFraming(plan)))
            return arm;
    }
    return std::nullopt;
}

/// The first to the second; nullopt without an interval.
std::optional<Contrast> ratioOf(const Results &results, const Place &place, Metric metric, const Pair &pair)
{
    const auto over = judgedArm(results.plan, pair.first), under = judgedArm(results.plan, pair.second);
    if (!over || !under)
        return std::nullopt;
    for (const Contrast &one : plannedContrasts(results, place.condition, place.load, metric)) {
        if (!std::isfinite(one.low()) || !std::isfinite(one.high()))
            continue;
        if (one.first == *under && one.second == *over)
            return one;
        if (one.first == *over && one.second == *under)
            return one.reversed();
    }
    return std::nullopt;
}

/// The clean link first, and there the load of the metric, then the paced ones from the fastest on, then the others.
std::vector<Place> placesFor(const Plan &plan, Metric metric)
{
    std::vector<Place> out;
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < plan.loads.size(); ++load)
            out.push_back({condition, load});
    }
    const auto rank = [&](const Place &place) {
        const Load load = plan.loads[place.load];
        const bool isOther = load != loadOf(metric);
        return std::tuple(!plan.conditions[place.condition].clean(), isOther, isOther && !load.isPaced(),
                          -static_cast<double>(load.perSecond));
    };
    std::ranges::stable_sort(out, {}, rank);
    return out;
}

/// The first place in which all of these ratios were measured, or the first with one of them; the first of all without any.
Place judgedPlace(const Results &results, Metric metric, const std::vector<Pair> &pairs)
{
    const std::vector<Place> places = placesFor(results.plan, metric);
    std::optional<Place> some;
    for (const Place &place : places) {
        const auto isMeasured = [&](const Pair &pair) { return ratioOf(results, place, metric, pair).has_value(); };
        if (std::ranges::all_of(pairs, isMeasured))
            return place;
        if (!some && std::ranges::any_of(pairs, isMeasured))
            some = place;
    }
    return some.value_or(places.front());
}

/// "CPU time per frame, station (cpu_per_frame, link clean, pps500 load, since the natural one has no such ratios, framing
/// sealed): "
std::string whereText(const Plan &plan, const Place &place, Metric metric)
{
    const Load load = plan.loads[place.load];
    return std::string(info(metric).title.english()) + " (" + std::string(info(metric).key) + ", link "
        + conditionText(plan.conditions[place.condition]) + ", " + name(load) + " load"
        + (load == loadOf(metric) ? "" : ", since the " + name(loadOf(metric)) + " one has no such ratios") + ", framing "
        + std::string(name(judgedFraming(plan))) + "): ";
}

/// A claim about a ratio. `margin` is the equivalence margin as a factor: 1.03.
using Judge = Finding (*)(double low, double high, double margin);

Finding isLower(double low, double high, double margin)
{
    return high < 1 / margin ? Finding::Confirmed : low > 1 / margin ? Finding::Refuted : Finding::NotDecided;
}

Finding isHigher(double low, double high, double margin)
{
    return isLower(1 / high, 1 / low, margin);
}

/// Not lower by as much as the margin.
Finding isAsHigh(double low, double high, double margin)
{
    return low > 1 / margin ? Finding::Confirmed : high < 1 / margin ? Finding::Refuted : Finding::NotDecided;
}

Finding isEqual(double low, double high, double margin)
{
    if (low > 1 / margin && high < margin)
        return Finding::Confirmed;
    return high < 1 / margin || low > margin ? Finding::Refuted : Finding::NotDecided;
}

/// With as many digits as a ratio near 1 takes: "1.00021".
std::string exactText(double ratio)
{
    return significantText(ratio, 6);
}

/// "chacha20 to rc4 0.85 (0.81 to 0.89)"; "chacha20 to rc4 1.0002" of a ratio that is exact.
std::string ratioText(const std::string &first, const std::string &second, double ratio, double low, double high)
{
    return first + " to " + second + " "
        + (low < high ? readable(ratio) + " (" + readable(low) + " to " + readable(high) + ")" : exactText(ratio));
}

/// Judges several ratios as one: all must be confirmed, and one that is refuted refutes the whole.
class Gathered
{
public:
    Gathered(const Plan &plan, Judge judge) : m_margin(plan.margin), m_judge(judge) {}

    void add(const Pair &pair, double ratio, double low, double high)
    {
        m_intervals.emplace_back(low, high);
        m_ratios.push_back({nameOf(pair.first), nameOf(pair.second), ratio, low, high});
        m_text += (m_text.empty() ? "" : "; ") + ratioText(nameOf(pair.first), nameOf(pair.second), ratio, low, high);
    }

    void addMissing(const Pair &pair)
    {
        m_missing += (m_missing.empty() ? "" : ", ") + nameOf(pair.first) + " to " + nameOf(pair.second);
    }

    Finding finding() const { return findingBy(1 + m_margin); }
    const std::vector<ClaimRatio> &ratios() const { return m_ratios; }

    /// Claim::decidable
    double decidable() const
    {
        for (const double end : ends()) {
            if (finding() == Finding::NotDecided && end > 1 + m_margin && findingBy(end * kBeyond) != Finding::NotDecided)
                return end - 1;
        }
        return kNaN;
    }

    /// Claim::decidableBelow
    double decidableBelow() const
    {
        const std::vector<double> all = ends();
        for (auto end = all.rbegin(); end != all.rend(); ++end) {
            if (finding() == Finding::NotDecided && *end > kBeyond && *end <= 1 + m_margin
                && findingBy(*end / kBeyond) != Finding::NotDecided)
                return *end - 1;
        }
        return kNaN;
    }

    std::string text() const
    {
        const bool anyInterval = std::ranges::any_of(m_intervals, [](const auto &one) { return one.first < one.second; });
        std::string out = m_text;
        if (!out.empty())
            out += (anyInterval ? "; ratios with their 95 % intervals, margin " : "; margin ") + percentText(m_margin) + ".";
        const double below = decidableBelow(), above = decidable();
        if (std::isfinite(below))
            out += " By a margin below " + percentText(below) + " it would be " + foundBy((1 + below) / kBeyond) + ".";
        if (std::isfinite(above))
            out += " By a margin of " + percentText(above) + " it would be " + foundBy((1 + above) * kBeyond) + ".";
        if (!m_missing.empty())
            out += (out.empty() ? "" : " ") + m_missing + ": not measured often enough for an interval.";
        return out;
    }

private:
    static constexpr double kBeyond = 1 + 1e-9;

    /// The margins, as ratios, at which findings change; ascending.
    std::vector<double> ends() const
    {
        std::vector<double> out;
        for (const auto &[low, high] : m_intervals)
            out.insert(out.end(), {low, high, 1 / low, 1 / high});
        std::ranges::sort(out);
        return out;
    }

    std::string foundBy(double margin) const { return std::string(findingText(findingBy(margin))); }

    Finding findingBy(double margin) const
    {
        bool all = !m_intervals.empty() && m_missing.empty();
        for (const auto &[low, high] : m_intervals) {
            const Finding found = m_judge(low, high, margin);
            if (found == Finding::Refuted)
                return found;
            all = all && found == Finding::Confirmed;
        }
        return all ? Finding::Confirmed : Finding::NotDecided;
    }

    const double m_margin;
    Judge m_judge;
    std::vector<std::pair<double, double>> m_intervals;
    std::vector<ClaimRatio> m_ratios;
    std::string m_text, m_missing;
};

std::vector<Pair> eachAgainst(SuiteId first, std::initializer_list<SuiteId> others)
{
    std::vector<Pair> out;
    for (const SuiteId other : others)
        out.push_back({first, other});
    return out;
}

/// A claim about ratios of one metric.
Claim judged(const Results &results, std::string_view key, std::string text, Metric metric, Judge judge,
             const std::vector<Pair> &pairs)
{
    const Place place = judgedPlace(results, metric, pairs);
    Gathered gathered(results.plan, judge);
    for (const Pair &pair : pairs) {
        if (const auto ratio = ratioOf(results, place, metric, pair))
            gathered.add(pair, ratio->value(), ratio->low(), ratio->high());
        else
            gathered.addMissing(pair);
    }
    Claim out{key,
              std::move(text),
              gathered.finding(),
              whereText(results.plan, place, metric) + gathered.text(),
              gathered.decidable(),
              gathered.decidableBelow(),
              gathered.ratios()};
    if (!isCompared(metric, results.plan.loads[place.load]))
        out.reason += " The vehicle sets this rate under that load, whatever the suite costs.";
    return out;
}

/// Memory that a suite adds to a process: the heap of a session, or of a keyed cipher. NaN if not measured.
double heapOf(const Results &results, SuiteId suite, bool ofSession)
{
    if (suite == SuiteId::None)
        return 0;
    if (!ofSession) {
        const auto found = results.contextBytes.find(suite);
        return found == results.contextBytes.end() ? kNaN : found->second;
    }
    for (const Cell &cell : cells(results.plan)) {
        const double mean = results.plan.arms[cell.arm].suite == suite
            ? summarise(valuesOf(results, cell, Metric::SessionMemory)).mean
            : kNaN;
        if (std::isfinite(mean))
            return mean;
    }
    return kNaN;
}

/// Of the measuring process, with all suites.
double residentOf(const Results &results)
{
    std::vector<double> values;
    for (const Sample &sample : results.samples) {
        if (sample.problem.empty())
            values.push_back(sample.values[Metric::Memory]);
    }
    return summarise(values).mean;
}

/// A claim about the memory of the process, which differs between suites by the heap of a session. That is a count, so that its
/// ratio is exact.
Claim judgedMemory(const Results &results, std::string_view key, std::string text, Judge judge, const std::vector<Pair> &pairs)
{
    Claim out{key, std::move(text), Finding::NotDecided, {}, kNaN};
    const double resident = residentOf(results);
    // One kind of heap for all suites, since a session has more than its cipher.
    const bool ofSession = std::ranges::all_of(pairs, [&](const Pair &pair) {
        return std::isfinite(heapOf(results, pair.first, true)) && std::isfinite(heapOf(results, pair.second, true));
    });
    Gathered gathered(results.plan, judge);
    std::string heaps;
    for (const Pair &pair : pairs) {
        const double one = heapOf(results, pair.first, ofSession), two = heapOf(results, pair.second, ofSession);
        const double ratio = (resident + one) / (resident + two);
        if (!std::isfinite(ratio)) {
            out.reason = "The memory of a session or of a keyed cipher was not measured for each of these suites.";
            return out;
        }
        gathered.add(pair, ratio, ratio, ratio);
        if (heaps.empty())
            heaps = nameOf(pair.first) + " " + readable(one) + " B";
        heaps += ", " + nameOf(pair.second) + " " + readable(two) + " B";
    }
    out.finding = gathered.finding();
    out.decidable = gathered.decidable();
    out.decidableBelow = gathered.decidableBelow();
    out.ratios = gathered.ratios();
    out.reason = "The station's process takes " + readable(resident / 1e6) + " MB with any suite; suites differ by the heap of "
        + (ofSession ? "a session" : "a keyed cipher") + ": " + heaps + ". To differ by the margin, a suite would have to take "
        + readable(results.plan.margin * resident / 1000) + " kB more; heaps are counts, so that the ratio has no interval. "
        + gathered.text();
    return out;
}

/// "none, chacha20 1.08 (1.05 to 1.11), …"
std::string orderHere(const Results &results, Metric metric, bool mostFirst)
{
    struct Standing
    {
        std::string text;
        double ratio;
    };
    std::vector<Pair> pairs;
    pairs.reserve(std::size(kPapers));
    for (const SuiteId suite : kPapers)
        pairs.push_back({suite, SuiteId::None});
    const Place where = judgedPlace(results, metric, pairs);
    std::vector<Standing> places{{"plain 1", 1}};
    for (const auto &[suite, plain] : pairs) {
        if (const auto ratio = ratioOf(results, where, metric, {suite, plain}))
            places.push_back({nameOf(suite) + " " + readable(ratio->value()) + " (" + readable(ratio->low()) + " to "
                                  + readable(ratio->high()) + ")",
                              ratio->value()});
    }
    if (places.size() < 2)
        return {};
    std::stable_sort(places.begin(), places.end(), [mostFirst](const Standing &a, const Standing &b) {
        return mostFirst ? a.ratio > b.ratio : a.ratio < b.ratio;
    });
    std::string out;
    for (const Standing &place : places)
        out += (out.empty() ? "" : ", ") + place.text;
    return out;
}

/// "plain 1, chacha20 1.0002": the memory of the process with a session of each suite, to that without; counts, no intervals.
std::string memoryOrderHere(const Results &results)
{
    const double resident = residentOf(results);
    const bool ofSession = std::ranges::all_of(kPapers, [&](SuiteId one) { return std::isfinite(heapOf(results, one, true)); });
    std::vector<std::pair<double, std::string>> places;
    for (const SuiteId suite : kPapers) {
        if (const double heap = heapOf(results, suite, ofSession); std::isfinite(heap))
            places.emplace_back(heap, nameOf(suite));
    }
    if (places.empty() || !std::isfinite(resident))
        return {};
    std::ranges::stable_sort(places, {}, &std::pair<double, std::string>::first);
    std::string out = "plain 1";
    for (const auto &[heap, name] : places)
        out += ", " + name + " " + exactText(1 + heap / resident);
    return out;
}

} // namespace

std::string_view findingText(Finding finding)
{
    switch (finding) {
    case Finding::Confirmed: return "confirmed";
    case Finding::Refuted: return "refuted";
    case Finding::NotDecided: break;
    }
    return "not decided";
}

std::vector<Claim> paperClaims(const Results &results)
{
    const std::vector<Pair> chacha = eachAgainst(SuiteId::ChaCha20, {kOthers[0], kOthers[1], kOthers[2]});
    const std::vector<Pair> rc4 = eachAgainst(SuiteId::Rc4, {SuiteId::ChaCha20, SuiteId::Aes256Ctr, SuiteId::Aes256Cbc});
    const std::vector<Pair> chachaToPlain = eachAgainst(SuiteId::ChaCha20, {SuiteId::None});
    std::vector<Claim> out;
    out.push_back(judged(results, "packets-best",
                         "ChaCha20 performs better than AES-CBC, AES-CTR and RC4: more packets in the same time.",
                         Metric::Packets, isHigher, chacha));
    out.push_back(judged(results, "cpu-least-station", "ChaCha20 needs less CPU than AES-CBC, AES-CTR and RC4: at the station.",
                         Metric::CpuPerFrame, isLower, chacha));
    out.push_back(judged(results, "cpu-least-drone",
                         "ChaCha20 needs less CPU than AES-CBC, AES-CTR and RC4: at the drone, by the agent.",
                         Metric::AgentCpuPerFrame, isLower, chacha));
    out.push_back(
        judgedMemory(results, "memory-least", "ChaCha20 occupies less memory than AES-CBC, AES-CTR and RC4.", isLower, chacha));
    out.push_back(judged(results, "packets-unharmed",
                         "Integrating ChaCha20 does not affect the performance of MAVLink: as many packets as without "
                         "encryption.",
                         Metric::Packets, isAsHigh, chachaToPlain));
    if (out.back().finding == Finding::Confirmed && judgedFraming(results.plan) == ArmFraming::Sealed)
        out.back().reason += " Sealing puts several frames into a record, and sending fewer datagrams makes it faster.";
    out.push_back(judged(results, "packets-plain-above",
                         "Without encryption slightly more packets than with ChaCha20 (by more than the margin).",
                         Metric::Packets, isHigher, eachAgainst(SuiteId::None, {SuiteId::ChaCha20})));
    std::vector<Pair> streams = eachAgainst(SuiteId::ChaCha20, {SuiteId::Aes256Cbc, SuiteId::Rc4});
    for (const Pair &pair : eachAgainst(SuiteId::Aes256Ctr, {SuiteId::Aes256Cbc, SuiteId::Rc4}))
        streams.push_back(pair);
    out.push_back(judged(results, "packets-streams", "ChaCha20 and AES-CTR transmit more packets than AES-CBC and RC4.",
                         Metric::Packets, isHigher, streams));
    out.push_back(judged(results, "rc4-cpu-station", "RC4 needs the most CPU of the four ciphers: at the station.",
                         Metric::CpuPerFrame, isHigher, rc4));
    out.push_back(judged(results, "rc4-cpu-drone", "RC4 needs the most CPU of the four ciphers: at the drone, by the agent.",
                         Metric::AgentCpuPerFrame, isHigher, rc4));
    out.push_back(judgedMemory(results, "rc4-memory", "RC4 occupies the most memory of the four ciphers.", isHigher, rc4));
    out.push_back(judged(results, "cpu-plain-station", "ChaCha20 needs as much CPU as no encryption: at the station.",
                         Metric::CpuPerFrame, isEqual, chachaToPlain));
    out.push_back(judged(results, "cpu-plain-drone", "ChaCha20 needs as much CPU as no encryption: at the drone, by the agent.",
                         Metric::AgentCpuPerFrame, isEqual, chachaToPlain));
    out.push_back(
        judgedMemory(results, "memory-plain", "ChaCha20 occupies as much memory as no encryption.", isEqual, chachaToPlain));
    out.push_back(
        {"battery", "Less CPU and memory save the drone's battery.", Finding::NotDecided,
         wasMeasured(results, Metric::EnergyPerFrame)
             ? "The measurement (energy_per_frame) is that of this machine with all programs of the sweep, above idle; it "
               "does not apply to a drone."
             : "Energy was not measured, and that of a desktop processor would not apply to a drone.",
         kNaN});
    out.push_back({"confidentiality", "Encryption with ChaCha20 guarantees confidentiality.", Finding::NotDecided,
                   "A measurement of costs cannot show it. Every suite is also authenticated here, unlike in the paper, so "
                   "the cost of the four classic ciphers includes HMAC-SHA-256.",
                   kNaN});
    return out;
}

std::vector<Ordering> orderings(const Results &results)
{
    std::vector<Ordering> out;
    const auto add = [&](std::string quantity, std::string paper, Metric metric, bool mostFirst) {
        if (std::string here = orderHere(results, metric, mostFirst); !here.empty())
            out.push_back({std::move(quantity), std::move(paper), std::move(here)});
    };
    add("Packets, the most first", "plain, chacha20; then aes-256-ctr; then aes-256-cbc and rc4", Metric::Packets, true);
    const std::string least = "chacha20 like plain; then the others, rc4 last";
    add("CPU time at the station, the least first", least, Metric::CpuPerFrame, false);
    add("CPU time at the drone, the least first", least, Metric::AgentCpuPerFrame, false);
    if (std::string here = memoryOrderHere(results); !out.empty() && !here.empty())
        out.push_back({"Memory of the process, the least first", least, here});
    return out;
}

} // namespace skyseal::experiment
