#include "core/experiment/plan.h"

#include "core/crypto/inline_cipher.h"
#include "core/experiment/metric.h"

#include <algorithm>
#include <charconv>

namespace skyseal::experiment {

namespace {

constexpr std::string_view kPaced = "pps";

std::uint64_t splitMix(std::uint64_t &state)
{
    std::uint64_t z = state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// Fisher–Yates. Not std::shuffle, whose order differs between standard libraries. The bias of the remainder is below 2^-56 for
/// lists of this length.
void shuffle(std::vector<Run> &runs, std::uint64_t &state)
{
    for (std::size_t i = runs.size(); i > 1; --i)
        std::swap(runs[i - 1], runs[splitMix(state) % i]);
}

struct Field
{
    std::string_view key;
    double most;
    void (*set)(impair::ImpairmentSettings &settings, double value);
};

Duration milliseconds(double value)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(value));
}

constexpr Field kFields[] = {
    {"loss", 1, [](impair::ImpairmentSettings &s, double v) { s.loss = v; }},
    {"duplicate", 1, [](impair::ImpairmentSettings &s, double v) { s.duplicate = v; }},
    {"reorder", 1, [](impair::ImpairmentSettings &s, double v) { s.reorder = v; }},
    {"corrupt", 1, [](impair::ImpairmentSettings &s, double v) { s.corrupt = v; }},
    {"delay", 60000, [](impair::ImpairmentSettings &s, double v) { s.delay = milliseconds(v); }},
    {"jitter", 60000, [](impair::ImpairmentSettings &s, double v) { s.jitter = milliseconds(v); }},
    {"rate", 1e9, [](impair::ImpairmentSettings &s, double v) { s.baud = static_cast<std::uint64_t>(v); }},
};

std::optional<InputError> setField(impair::ImpairmentSettings &settings, std::string_view item)
{
    const auto wrong = [&](const std::string &why) { return InputError{"'" + std::string(item) + "': " + why, {}}; };
    const std::size_t sign = item.find('=');
    if (sign == std::string_view::npos)
        return wrong("KEY=VALUE is expected");
    const auto field = std::find_if(std::begin(kFields), std::end(kFields),
                                    [&](const Field &candidate) { return candidate.key == item.substr(0, sign); });
    if (field == std::end(kFields))
        return wrong("there are loss, duplicate, reorder, corrupt, delay, jitter and rate");
    const std::string_view text = item.substr(sign + 1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= 0 && value <= field->most))
        return wrong("a number from 0 to " + std::to_string(static_cast<std::uint64_t>(field->most)) + " is expected");
    field->set(settings, value);
    return std::nullopt;
}

} // namespace

Reason nameReason(Load load)
{
    switch (load.kind) {
    case Load::Kind::Natural: return sentence("Reason", "natural");
    case Load::Kind::Saturated: return sentence("Reason", "saturated");
    case Load::Kind::Paced: break;
    }
    return sentence("Reason", "pps%1")(load.perSecond);
}

std::string name(Load load)
{
    return nameReason(load).text();
}

std::optional<Load> loadFromName(std::string_view text)
{
    for (const Load known : {Load::Natural, Load::Saturated}) {
        if (text == name(known))
            return known;
    }
    if (!text.starts_with(kPaced))
        return std::nullopt;
    Load out = Load::paced(0);
    std::from_chars(text.data() + kPaced.size(), text.data() + text.size(), out.perSecond);
    const bool isOne = out.perSecond > 0 && out.perSecond <= kMostPaced && text == name(out); // in its only spelling
    return isOne ? std::optional(out) : std::nullopt;
}

/// Plain MAVLink has no framing.
static Reason suiteReason(const SweepArm &arm, bool isFramingNamed)
{
    if (arm.suite == crypto::SuiteId::None)
        return sentence("Reason", "none");
    const std::string suite(crypto::suiteInfo(arm.suite).name);
    if (!isFramingNamed)
        return suite;
    switch (arm.framing) {
    case ArmFraming::Inline: return sentence("Reason", "%1 inline")(suite);
    case ArmFraming::Bare: return sentence("Reason", "%1 bare")(suite);
    case ArmFraming::Sealed: break;
    }
    return sentence("Reason", "%1 sealed")(suite);
}

static Reason withRepetition(const SweepArm &arm, const Reason &suite)
{
    return arm.again ? sentence("Reason", "%1 (A/A)")(suite) : suite;
}

Reason nameReason(const SweepArm &arm)
{
    return withRepetition(arm, suiteReason(arm, arm.framing != ArmFraming::Sealed));
}

Reason fullNameReason(const SweepArm &arm)
{
    return withRepetition(arm, suiteReason(arm, true));
}

std::string name(const SweepArm &arm)
{
    return nameReason(arm).text();
}

std::string fullName(const SweepArm &arm)
{
    return fullNameReason(arm).text();
}

std::string_view framingName(const SweepArm &arm)
{
    return arm.suite == crypto::SuiteId::None ? "plain" : name(arm.framing);
}

std::string_view name(ArmFraming framing)
{
    switch (framing) {
    case ArmFraming::Inline: return "inline";
    case ArmFraming::Bare: return "bare";
    case ArmFraming::Sealed: break;
    }
    return "sealed";
}

std::optional<ArmFraming> framingFromName(std::string_view text)
{
    const auto found = std::ranges::find_if(kFramings, [&](ArmFraming one) { return name(one) == text; });
    return found == std::end(kFramings) ? std::nullopt : std::optional(*found);
}

std::optional<crypto::MavsecKind> bareCipherOf(const SweepArm &arm)
{
    if (arm.framing != ArmFraming::Bare)
        return std::nullopt;
    switch (arm.suite) {
    case crypto::SuiteId::ChaCha20: return crypto::MavsecKind::ChaCha20;
    case crypto::SuiteId::Aes256Ctr: return crypto::MavsecKind::Aes256Ctr;
    default: return std::nullopt;
    }
}

bool exists(const SweepArm &arm)
{
    if (arm.framing == ArmFraming::Sealed || arm.suite == crypto::SuiteId::None)
        return true;
    return arm.framing == ArmFraming::Inline ? crypto::mayBeInline(arm.suite) : bareCipherOf(arm).has_value();
}

std::vector<SweepArm> armsOf(const std::vector<crypto::SuiteId> &suites, const std::vector<ArmFraming> &framings, bool noise)
{
    std::vector<SweepArm> out;
    for (const crypto::SuiteId suite : suites) {
        if (suite == crypto::SuiteId::None)
            out.push_back({suite, false, ArmFraming::Sealed});
    }
    for (const ArmFraming framing : framings) {
        for (const crypto::SuiteId suite : suites) {
            if (suite != crypto::SuiteId::None)
                out.push_back({suite, false, framing});
        }
    }
    if (!noise)
        return out;
    auto twice = std::find(out.begin(), out.end(), SweepArm{crypto::SuiteId::ChaCha20Poly1305, false, ArmFraming::Sealed});
    const auto usable = [](const SweepArm &arm) { return exists(arm) && arm.suite != crypto::SuiteId::None; };
    if (twice == out.end())
        twice = std::find_if(out.begin(), out.end(), usable);
    if (twice == out.end())
        twice = out.begin(); // plain MAVLink alone
    if (twice != out.end())
        out.push_back({twice->suite, true, twice->framing});
    return out;
}

std::vector<ArmFraming> framingsOf(const Plan &plan)
{
    std::vector<ArmFraming> out;
    for (const ArmFraming framing : kFramings) {
        const auto has = [framing](const SweepArm &arm) { return framingName(arm) == name(framing); };
        if (std::any_of(plan.arms.begin(), plan.arms.end(), has))
            out.push_back(framing);
    }
    return out;
}

bool isInsecure(const SweepArm &arm)
{
    const crypto::SuiteInfo &info = crypto::suiteInfo(arm.suite);
    return info.research || !info.authenticated || arm.framing == ArmFraming::Bare;
}

Result<Condition, InputError> parseCondition(std::string_view text)
{
    Condition out;
    out.name = std::string(text);
    if (out.clean())
        return out;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (auto wrong = setField(out.settings, text.substr(begin, end - begin)))
            return tl::unexpected(*wrong);
        begin = end + 1;
    }
    return out;
}

std::string conditionText(const Condition &condition)
{
    if (condition.clean())
        return condition.name;
    std::string out;
    const auto add = [&out](bool is, const std::string &text) {
        if (is)
            out += (out.empty() ? "" : ", ") + text;
    };
    const auto percent = [](double share) { return readable(100 * share) + " % "; };
    const auto ms = [](Duration time) { return readable(1000 * seconds(time)) + " ms"; };
    const impair::ImpairmentSettings &link = condition.settings;
    add(link.baud > 0, readable(static_cast<double>(link.baud)) + " baud");
    add(link.loss > 0, percent(link.loss) + "loss");
    add(link.duplicate > 0, percent(link.duplicate) + "duplicates");
    add(link.reorder > 0, percent(link.reorder) + "reordered");
    add(link.corrupt > 0, percent(link.corrupt) + "corrupted");
    add(link.delay > Duration::zero(), ms(link.delay) + " delay");
    add(link.jitter > Duration::zero(), "up to " + ms(link.jitter) + " jitter");
    return out.empty() ? "no impairment" : out;
}

static void appendLaunch(std::vector<Run> &out, const Plan &plan, unsigned launch)
{
    std::uint64_t state = seedOf(plan, launch);
    for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
        for (std::size_t load = 0; load < plan.loads.size(); ++load) {
            for (unsigned repeat = 0; repeat < plan.repeats; ++repeat) {
                std::vector<Run> block;
                for (std::size_t arm = 0; arm < plan.arms.size(); ++arm) {
                    if (exists(plan.arms[arm]))
                        block.push_back({condition, load, arm, repeat, launch});
                }
                shuffle(block, state);
                out.insert(out.end(), block.begin(), block.end());
            }
        }
    }
}

std::vector<Run> schedule(const Plan &plan)
{
    std::vector<Run> out;
    for (unsigned launch = 0; launch < plan.launches; ++launch)
        appendLaunch(out, plan, launch);
    return out;
}

unsigned phaseOf(const Plan &plan, const Run &run)
{
    return run.repeat % plan.phases;
}

std::uint64_t seedOf(const Plan &plan, unsigned launch)
{
    if (launch == 0)
        return plan.seed;
    std::uint64_t state = plan.seed ^ (std::uint64_t(launch) << 32);
    return splitMix(state) >> 32; // short enough to be typed again
}

} // namespace skyseal::experiment
