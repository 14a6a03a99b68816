#include "core/experiment/contrast.h"

#include "core/experiment/block_model.h"
#include "core/experiment/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace skyseal::experiment {

using crypto::SuiteId;

namespace {

constexpr std::size_t kLeastUnvaried = 5; ///< launches or blocks; a count that was the same a few times may still vary by one
constexpr double kRounding = 1e-11;       ///< of logarithms and of shares

/// Pairs that claims of the paper are about, within one framing.
constexpr std::array<std::pair<SuiteId, SuiteId>, 6> kClaimed{{
    {SuiteId::ChaCha20, SuiteId::Aes256Cbc},
    {SuiteId::ChaCha20, SuiteId::Aes256Ctr},
    {SuiteId::ChaCha20, SuiteId::Rc4},
    {SuiteId::Aes256Ctr, SuiteId::Aes256Cbc},
    {SuiteId::Aes256Ctr, SuiteId::Rc4},
    {SuiteId::Aes256Cbc, SuiteId::Rc4},
}};

double stepOf(const Plan &plan, Metric metric, double mean, double other)
{
    const Resolution &resolution = info(metric).resolution;
    const double frames = resolution.frames / (resolution.perSecond ? seconds(plan.measure) : 1);
    return std::max(frames, resolution.share * std::max(std::abs(mean), std::abs(other)));
}

bool hasMeaning(const SweepArm &arm, Metric metric)
{
    return exists(arm) && !(info(metric).zeroInPlain && arm.suite == SuiteId::None);
}

/// The valid runs of all arms under one condition and load, by one metric.
class Compared
{
public:
    Compared(const Results &results, std::size_t condition, std::size_t load, Metric metric)
        : m_results(results), m_condition(condition), m_load(load), m_metric(metric),
          m_relative(!info(metric).isShare() && !info(metric).canBeNegative), m_model(valuesOf(), results.plan.arms.size())
    {}

    /// Not corrected yet; nullopt with less than two values of each.
    std::optional<Contrast> between(std::size_t first, std::size_t second) const
    {
        const Summary one = summarise(experiment::valuesOf(m_results, {m_condition, m_load, first}, m_metric));
        const Summary two = summarise(experiment::valuesOf(m_results, {m_condition, m_load, second}, m_metric));
        if (one.count < 2 || two.count < 2)
            return std::nullopt;
        const BlockContrast fitted = m_model.contrast(first, second);
        if (!std::isfinite(fitted.estimate))
            return std::nullopt;
        Contrast out;
        out.condition = m_condition;
        out.load = m_load;
        out.metric = m_metric;
        out.first = first;
        out.second = second;
        out.relative = m_relative;
        out.estimate = std::abs(fitted.estimate) < kRounding ? 0 : fitted.estimate;
        out.degrees = fitted.degrees;
        out.error = fitted.error < kRounding ? 0 : fitted.error;
        out.firstMean = one.mean;
        out.secondMean = two.mean;
        out.step = stepOf(m_results.plan, m_metric, one.mean, two.mean);
        out.units = fitted.units;
        out.ofLaunches = m_model.hasLaunches();
        if (std::isnan(out.error) || (out.error == 0 && out.units < kLeastUnvaried))
            out.p = out.error = kNaN;
        else if (out.error == 0) // counts that never vary: any difference is one
            out.p = out.estimate == 0 ? 1 : 0;
        else
            out.p = studentTwoSided(out.estimate / out.error, out.degrees);
        return out;
    }

private:
    std::vector<BlockValue> valuesOf() const
    {
        std::vector<BlockValue> out;
        for (const Sample &sample : m_results.samples) {
            const double value = sample.values[m_metric];
            const bool counts = sample.run.condition == m_condition && sample.run.load == m_load && sample.isValid()
                && hasMeaning(m_results.plan.arms[sample.run.arm], m_metric) && std::isfinite(value);
            if (counts && (!m_relative || value > 0))
                out.push_back({sample.run.launch, sample.run.repeat, sample.run.arm, m_relative ? std::log(value) : value});
        }
        return out;
    }

    const Results &m_results;
    std::size_t m_condition, m_load;
    Metric m_metric;
    bool m_relative;
    BlockModel m_model;
};

void correct(std::vector<Contrast> &family)
{
    std::vector<double> p;
    p.reserve(family.size());
    for (const Contrast &one : family)
        p.push_back(one.p);
    const std::vector<double> adjusted = holm(p);
    for (std::size_t i = 0; i < family.size(); ++i)
        family[i].adjusted = adjusted[i];
}

/// Pairs of arms: each against the reference, then those of the claims, then each bare cipher against itself with its HMAC.
std::vector<std::pair<std::size_t, std::size_t>> plannedPairs(const Plan &plan, Metric metric)
{
    std::vector<std::pair<std::size_t, std::size_t>> out;
    const auto isArm = [&](std::size_t arm) { return !plan.arms[arm].again && hasMeaning(plan.arms[arm], metric); };
    const std::optional<std::size_t> reference = referenceArm(plan);
    for (std::size_t arm = 0; reference && isArm(*reference) && arm < plan.arms.size(); ++arm) {
        if (arm != *reference && isArm(arm))
            out.emplace_back(*reference, arm);
    }
    for (const auto &[one, two] : kClaimed) {
        for (std::size_t first = 0; first < plan.arms.size(); ++first) {
            for (std::size_t second = 0; second < plan.arms.size(); ++second) {
                const SweepArm &a = plan.arms[first], &b = plan.arms[second];
                const bool isPair = a.suite == one && b.suite == two && a.framing == b.framing && isArm(first) && isArm(second);
                if (isPair && first != reference && second != reference)
                    out.emplace_back(first, second);
            }
        }
    }
    for (std::size_t bare = 0; bare < plan.arms.size(); ++bare) {
        const auto hmac = std::ranges::find(plan.arms, SweepArm{plan.arms[bare].suite, false, ArmFraming::Inline});
        const auto with = static_cast<std::size_t>(hmac - plan.arms.begin());
        if (plan.arms[bare].framing == ArmFraming::Bare && hmac != plan.arms.end() && isArm(bare) && isArm(with)
            && bare != reference)
            out.emplace_back(bare, with);
    }
    return out;
}

} // namespace

double Contrast::value() const
{
    return relative ? std::exp(estimate) : estimate;
}

double Contrast::halfWidth(double confidence) const
{
    if (error == 0)
        return 0;
    return degrees > 0 ? studentQuantile((1 + confidence) / 2, degrees) * error : kNaN;
}

double Contrast::low(double confidence) const
{
    const double end = estimate - halfWidth(confidence);
    return relative ? std::exp(end) : end;
}

double Contrast::high(double confidence) const
{
    const double end = estimate + halfWidth(confidence);
    return relative ? std::exp(end) : end;
}

double Contrast::difference() const
{
    return relative ? firstMean * std::expm1(estimate) : estimate;
}

bool Contrast::beyondStep() const
{
    return std::abs(difference()) > step * (1 + 1e-9); // a step exactly is none, whatever the logarithms round
}

bool Contrast::known() const
{
    return !std::isnan(p) || !beyondStep();
}

Contrast Contrast::reversed() const
{
    Contrast out = *this;
    std::swap(out.first, out.second);
    std::swap(out.firstMean, out.secondMean);
    out.estimate = -estimate;
    return out;
}

std::optional<std::size_t> referenceArm(const Plan &plan)
{
    auto found = std::ranges::find(plan.arms, SuiteId::None, &SweepArm::suite);
    if (found == plan.arms.end())
        found = std::ranges::find_if(plan.arms, [](const SweepArm &arm) { return exists(arm); });
    return found == plan.arms.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - plan.arms.begin()));
}

bool isCompared(Metric metric, Load load)
{
    const MetricInfo &described = info(metric);
    return described.independent && !described.explains && !described.oncePerSuite
        && !(described.setByVehicle && load != Load::Saturated);
}

std::vector<Contrast> plannedContrasts(const Results &results, std::size_t condition, std::size_t load, Metric metric)
{
    std::vector<Contrast> out;
    if (!isCompared(metric, results.plan.loads[load]))
        return out;
    const Compared compared(results, condition, load, metric);
    for (const auto &[first, second] : plannedPairs(results.plan, metric)) {
        if (auto contrast = compared.between(first, second))
            out.push_back(*contrast);
    }
    correct(out);
    return out;
}

std::vector<Contrast> noiseContrasts(const Results &results)
{
    std::vector<Contrast> out;
    const std::vector<SweepArm> &arms = results.plan.arms;
    const auto again = std::ranges::find_if(arms, &SweepArm::again);
    if (again == arms.end())
        return out;
    const auto first = std::find(arms.begin(), arms.end(), SweepArm{again->suite, false, again->framing});
    if (first == arms.end())
        return out;
    for (std::size_t condition = 0; condition < results.plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < results.plan.loads.size(); ++load) {
            for (const MetricInfo &metric : metrics()) {
                if (!isCompared(metric.metric, results.plan.loads[load]) || !hasMeaning(*again, metric.metric))
                    continue;
                const Compared compared(results, condition, load, metric.metric);
                if (auto noise = compared.between(static_cast<std::size_t>(first - arms.begin()),
                                                  static_cast<std::size_t>(again - arms.begin())))
                    out.push_back(*noise);
            }
        }
    }
    correct(out);
    return out;
}

} // namespace skyseal::experiment
