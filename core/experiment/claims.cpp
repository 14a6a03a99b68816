#include "core/experiment/claims.h"

#include "core/experiment/analysis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyseal::experiment {

namespace {

using crypto::SuiteId;

constexpr std::array kRivals{SuiteId::Aes256Cbc, SuiteId::Aes256Ctr, SuiteId::Rc4};
constexpr double kAsGood = 0.02; ///< smaller relative differences have no practical effect

std::string nameOf(SuiteId suite)
{
    return std::string(crypto::suiteInfo(suite).name);
}

/// The framing that the claims are judged in.
channel::Framing judgedFraming(const Plan &plan)
{
    const auto framings = framingsOf(plan);
    return framings.empty() ? channel::Framing::Sealed : framings.back();
}

/// Where claims are judged: on the clean link where it is among the conditions, packets and CPU under the saturated load.
struct Place
{
    std::size_t condition = 0, load = 0;
};

Place judgedPlace(const Plan &plan)
{
    const auto clean = std::find_if(plan.conditions.begin(), plan.conditions.end(),
                                    [](const Condition &one) { return one.clean(); });
    const auto busy = std::find(plan.loads.begin(), plan.loads.end(), Load::Saturated);
    return {clean == plan.conditions.end() ? 0 : static_cast<std::size_t>(clean - plan.conditions.begin()),
            busy == plan.loads.end() ? 0 : static_cast<std::size_t>(busy - plan.loads.begin())};
}

/// "CPU time per frame, station (cpu_per_frame, link clean, saturated load, framing sealed): "
std::string whereText(const Plan &plan, const Place &place, Metric metric)
{
    return std::string(info(metric).title) + " (" + std::string(info(metric).key) + ", link "
        + conditionText(plan.conditions[place.condition]) + ", " + std::string(name(plan.loads[place.load])) + " load, framing "
        + std::string(name(judgedFraming(plan))) + "): ";
}

/// The mean of the second suite relative to that of the first.
struct Standing
{
    bool compared = false;                   ///< both suites were measured at least twice
    bool known = false, significant = false; ///< see Comparison
    double ratio = 1;
    double margin = 0; ///< half of the 90 % interval of the difference, as a share of the first one's mean
    std::string text;
};

Standing standing(const Results &results, const Place &place, Metric metric, SuiteId first, SuiteId second)
{
    Standing out;
    for (const ArmComparison &pair : compareArms(results, place.condition, place.load, metric)) {
        const SweepArm &one = results.plan.arms[pair.first], &two = results.plan.arms[pair.second];
        const channel::Framing framing = judgedFraming(results.plan);
        if ((one.suite != SuiteId::None && one.framing != framing) || two.framing != framing)
            continue; // plain MAVLink is always the first arm
        const SuiteId a = one.suite, b = two.suite;
        if (!((a == first && b == second) || (a == second && b == first)))
            continue;
        const double other = pair.firstMean + pair.comparison.test.difference;
        const double mine = a == first ? pair.firstMean : other, theirs = a == first ? other : pair.firstMean;
        out.compared = true;
        out.known = pair.comparison.known();
        out.significant = pair.comparison.significant();
        out.ratio = theirs / mine;
        out.margin = pair.comparison.test.halfWidth(0.9) / mine;
        out.text = nameOf(second) + " " + readable(theirs) + " against " + readable(mine)
            + (!out.known                               ? " (neither varies, in too few runs to say whether they differ)"
                   : !out.significant                   ? " (no significant difference)"
                   : std::abs(out.ratio - 1) <= kAsGood ? " (less than 2 % apart)"
                                                        : "");
        return out;
    }
    return out;
}

/// ChaCha20 against each of the paper's other ciphers; better means less, or more with `moreIsBetter`.
Claim against(const Results &results, const Place &place, Metric metric, bool moreIsBetter, std::string text)
{
    Claim out{std::move(text), Finding::CannotBeSaid, {}};
    std::size_t better = 0, worse = 0, compared = 0;
    std::string list;
    for (const SuiteId rival : kRivals) {
        const Standing found = standing(results, place, metric, SuiteId::ChaCha20, rival);
        if (!found.compared)
            continue;
        ++compared;
        if (found.significant && std::abs(found.ratio - 1) > kAsGood)
            ++((found.ratio > 1) != moreIsBetter ? better : worse);
        list += (list.empty() ? "" : "; ") + found.text;
    }
    out.reason = compared == 0
        ? whereText(results.plan, place, metric) + "ChaCha20 and the other ciphers were not measured twice each."
        : whereText(results.plan, place, metric) + list + " for chacha20.";
    if (worse > 0)
        out.finding = Finding::NotConfirmed;
    else if (better == kRivals.size())
        out.finding = Finding::Confirmed;
    return out;
}

/// As good as plain MAVLink or better, by two one-sided tests, so that few or scattered samples do not confirm the claim.
Claim unharmed(const Results &results, const Place &place)
{
    Claim out{"Integrating ChaCha20 does not affect the performance of MAVLink: as many packets as without encryption.",
              Finding::CannotBeSaid, "Plain MAVLink and ChaCha20 were not measured twice each."};
    const Standing found = standing(results, place, Metric::Packets, SuiteId::None, SuiteId::ChaCha20);
    if (!found.compared)
        return out;
    out.reason = whereText(results.plan, place, Metric::Packets) + found.text + " for plain MAVLink.";
    if (results.plan.loads[place.load] == Load::Natural) {
        out.reason +=
            " The vehicle sets this rate, whatever the suite costs; the claim can be tested only under the saturated load.";
        return out;
    }
    const double change = found.ratio - 1;
    const bool more = found.significant && change > kAsGood;
    if (found.significant && change < -kAsGood)
        out.finding = Finding::NotConfirmed;
    else if (more || std::abs(change) + found.margin <= kAsGood)
        out.finding = Finding::Confirmed;
    else
        out.reason += " The difference, " + readable(100 * change) + " ± " + readable(100 * found.margin)
            + " % (90 % confidence interval), is not known to be within 2 %.";
    if (more && judgedFraming(results.plan) == channel::Framing::Sealed)
        out.reason += " Sealing puts several frames into a record, and sending fewer datagrams makes it faster.";
    return out;
}

Claim memory(const std::function<double(SuiteId)> &contextBytes)
{
    Claim out{"ChaCha20 occupies less memory than AES-CBC, AES-CTR and RC4.", Finding::CannotBeSaid,
              "The programs keep running while suites change, so resident memory does not belong to one suite."};
    std::string list;
    for (const SuiteId suite : {SuiteId::ChaCha20, SuiteId::Aes256Cbc, SuiteId::Aes256Ctr, SuiteId::Rc4}) {
        if (const double bytes = contextBytes(suite); std::isfinite(bytes))
            list += (list.empty() ? " Heap of one keyed cipher: " : ", ") + nameOf(suite) + " " + readable(bytes) + " B";
    }
    out.reason += list.empty() ? "" : list + "; negligible beside a process of several megabytes.";
    return out;
}

} // namespace

std::string_view findingText(Finding finding)
{
    switch (finding) {
    case Finding::Confirmed: return "confirmed";
    case Finding::NotConfirmed: return "not confirmed";
    case Finding::CannotBeSaid: break;
    }
    return "cannot be said from this data";
}

std::vector<Claim> paperClaims(const Results &results, const std::function<double(SuiteId)> &contextBytes)
{
    const Place place = judgedPlace(results.plan);
    std::vector<Claim> out;
    out.push_back(against(results, place, Metric::Packets, true,
                          "ChaCha20 performs better than AES-CBC, AES-CTR and RC4: more packets in the same time."));
    out.push_back(against(results, place, Metric::CpuPerFrame, false,
                          "ChaCha20 needs less CPU than AES-CBC, AES-CTR and RC4: at the station."));
    out.push_back(against(results, place, Metric::AgentCpuPerFrame, false,
                          "ChaCha20 needs less CPU than AES-CBC, AES-CTR and RC4: at the drone, by the agent."));
    out.push_back(memory(contextBytes));
    out.push_back(unharmed(results, place));
    out.push_back(
        {"Less CPU and memory save the drone's battery.", Finding::CannotBeSaid,
         wasMeasured(results, Metric::EnergyPerFrame)
             ? "The measurement (energy_per_frame) covers the whole processor of this machine, including idle power; it "
               "does not apply to a drone."
             : "Energy was not measured, and that of a desktop processor would not apply to a drone."});
    out.push_back({"Encryption with ChaCha20 guarantees confidentiality.", Finding::CannotBeSaid,
                   "A measurement of costs cannot show it. Every suite is also authenticated here, unlike in the paper, so "
                   "the cost of the four classic ciphers includes HMAC-SHA-256."});
    return out;
}

} // namespace skyseal::experiment
