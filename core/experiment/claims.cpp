#include "core/experiment/claims.h"

#include "core/experiment/analysis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyseal::experiment {

namespace {

using crypto::SuiteId;

constexpr std::array kRivals{SuiteId::Aes256Cbc, SuiteId::Aes256Ctr, SuiteId::Rc4};
constexpr double kAsGood = 0.02; ///< a smaller share of difference does not matter to anybody's flight

std::string shown(SuiteId suite)
{
    return std::string(crypto::suiteInfo(suite).name);
}

/// The framing that the claims are judged in.
channel::Framing judgedFraming(const Plan &plan)
{
    const auto framings = framingsOf(plan);
    return framings.empty() ? channel::Framing::Sealed : framings.back();
}

/// How the second suite's mean stands to the first one's.
struct Standing
{
    bool compared = false, significant = false;
    double ratio = 1;
    std::string text;
};

Standing standing(const Results &results, std::size_t load, Metric metric, SuiteId first, SuiteId second)
{
    Standing out;
    for (const ArmComparison &pair : compareArms(results, 0, load, metric)) {
        const Arm &one = results.plan.arms[pair.first], &two = results.plan.arms[pair.second];
        const channel::Framing framing = judgedFraming(results.plan);
        if ((one.suite != SuiteId::None && one.framing != framing) || two.framing != framing)
            continue; // plain MAVLink is always the first arm
        const SuiteId a = one.suite, b = two.suite;
        if (!((a == first && b == second) || (a == second && b == first)))
            continue;
        const double other = pair.firstMean + pair.comparison.test.difference;
        const double mine = a == first ? pair.firstMean : other, theirs = a == first ? other : pair.firstMean;
        out.compared = true;
        out.significant = pair.comparison.significant();
        out.ratio = theirs / mine;
        out.text = shown(second) + " " + readable(theirs) + " against " + readable(mine)
                   + (out.significant ? "" : " (no significant difference)");
        return out;
    }
    return out;
}

/// ChaCha20 against each of the paper's other ciphers; better means less, or more with `moreIsBetter`.
Claim against(const Results &results, std::size_t load, Metric metric, bool moreIsBetter, std::string text)
{
    Claim out{std::move(text), Finding::CannotBeSaid, {}};
    std::size_t better = 0, worse = 0, compared = 0;
    std::string list;
    for (const SuiteId rival : kRivals) {
        const Standing found = standing(results, load, metric, SuiteId::ChaCha20, rival);
        if (!found.compared)
            continue;
        ++compared;
        if (found.significant)
            ++((found.ratio > 1) != moreIsBetter ? better : worse);
        list += (list.empty() ? "" : "; ") + found.text;
    }
    const std::string where = std::string(info(metric).title) + " (" + std::string(info(metric).key) + ", "
                              + std::string(name(results.plan.loads[load])) + " load, framing "
                              + std::string(name(judgedFraming(results.plan))) + "): ";
    out.reason = compared == 0 ? "ChaCha20 and the other ciphers were not measured twice each" : where + list + " for chacha20.";
    if (worse > 0)
        out.finding = Finding::NotConfirmed;
    else if (better == kRivals.size())
        out.finding = Finding::Confirmed;
    return out;
}

Claim unharmed(const Results &results, std::size_t load)
{
    Claim out{"Integrating ChaCha20 does not affect the performance of MAVLink: as many packets as without encryption.",
              Finding::CannotBeSaid, "Plain MAVLink and ChaCha20 were not measured twice each."};
    const Standing found = standing(results, load, Metric::Packets, SuiteId::None, SuiteId::ChaCha20);
    if (!found.compared)
        return out;
    const channel::Framing framing = judgedFraming(results.plan);
    out.reason = std::string("Packets in the same time (") + std::string(name(results.plan.loads[load])) + " load, framing "
                 + std::string(name(framing)) + "): " + found.text + " for plain MAVLink.";
    if (!found.significant && std::abs(found.ratio - 1) <= kAsGood)
        out.finding = Finding::Confirmed;
    else if (found.significant && found.ratio < 1 - kAsGood)
        out.finding = Finding::NotConfirmed;
    else if (found.significant && found.ratio > 1 + kAsGood) {
        out.finding = Finding::Confirmed;
        if (framing == channel::Framing::Sealed)
            out.reason += " Sealing puts several frames into a record, and fewer datagrams are what makes it quicker.";
    }
    return out;
}

Claim memory(const Results &results, std::size_t load, const std::function<double(SuiteId)> &contextBytes)
{
    Claim out = against(results, load, Metric::AgentMemory, false, "ChaCha20 occupies less memory than AES-CBC, AES-CTR and RC4.");
    out.finding = Finding::CannotBeSaid;
    out.reason += " The programs keep running while suites change, so resident memory does not belong to one suite.";
    std::string list;
    for (const SuiteId suite : {SuiteId::ChaCha20, SuiteId::Aes256Cbc, SuiteId::Aes256Ctr, SuiteId::Rc4}) {
        if (const double bytes = contextBytes(suite); std::isfinite(bytes))
            list += (list.empty() ? " One keyed cipher takes of the heap: " : ", ") + shown(suite) + " " + readable(bytes) + " B";
    }
    out.reason += list.empty() ? "" : list + "; next to a process of several megabytes that is nothing.";
    return out;
}

} // namespace

std::string_view words(Finding finding)
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
    const auto &loads = results.plan.loads;
    const auto index = [&](Load wanted) {
        const auto found = std::find(loads.begin(), loads.end(), wanted);
        return found == loads.end() ? std::size_t(0) : static_cast<std::size_t>(found - loads.begin());
    };
    const std::size_t natural = index(Load::Natural);
    const std::size_t busy = std::find(loads.begin(), loads.end(), Load::Saturated) == loads.end() ? natural : index(Load::Saturated);
    std::vector<Claim> out;
    out.push_back(against(results, busy, Metric::Packets, true,
                          "ChaCha20 performs better than AES-CBC, AES-CTR and RC4: more packets in the same time."));
    out.push_back(against(results, busy, Metric::CpuPerFrame, false,
                          "ChaCha20 needs less CPU than AES-CBC, AES-CTR and RC4."));
    out.push_back(memory(results, busy, contextBytes));
    out.push_back(unharmed(results, natural));
    out.push_back({"Less CPU and memory save the drone's battery.", Finding::CannotBeSaid,
                   wasMeasured(results, Metric::EnergyPerFrame)
                       ? "What was measured (energy_per_frame) is the whole processor of this machine, idle power included; it "
                         "is not a drone's."
                       : "Energy was not measured, and a desktop processor's would not be a drone's."});
    out.push_back({"Encryption with ChaCha20 guarantees confidentiality.", Finding::CannotBeSaid,
                   "No measurement of cost can show it. Here every suite is authenticated as well, which the paper's are not, so "
                   "the cost of the four classic ciphers holds that of HMAC-SHA-256."});
    return out;
}

} // namespace skyseal::experiment
