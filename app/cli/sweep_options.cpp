#include "app/cli/sweep_options.h"

#include "app/common/options.h"
#include "app/common/sweep_command_line.h"
#include "core/base/research.h"
#include "core/crypto/system_random.h"
#include "core/experiment/placement.h"
#include "core/experiment/precision.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace skyseal::app {

namespace {

using experiment::Load;

/// The link of a saturated load where the programs have no cores of their own. There a clean link uses up all cores together
/// before the station or the agent has used up one, so that no run would be valid; any machine fills this line.
constexpr const char *kFillable = "rate=921600";
constexpr unsigned kPilotLaunches = 3, kMostLaunchesUntil = 100;

void declareSweepOptions(Options &options)
{
    options.addLink("link", "Link to the vehicle's agent. Without it a simulator and an agent are started for the sweep.",
                    isLive);
    options.addLink("vehicle",
                    "Link to a running autopilot, such as tcp:127.0.0.1:5760, a serial port or udpin:14560; the sweep starts "
                    "its own agent and impairments.",
                    isLive);
    options.addValue("fly", "SCRIPT",
                     "With --vehicle: a flight script, as of monitor --do, that each repeat flies. All suites are measured "
                     "before its landing (land, rtl, disarm), or in each phase that a '|' between two steps marks. However "
                     "the sweep ends, the vehicle lands and is disarmed first; only a sweep of one launch that is killed "
                     "(SIGKILL) cannot do that, and leaves the vehicle to its failsafe for a lost ground station.");
    options.addValue("identity", "FILE", "With --link: private key of this station.");
    options.addValue("peers", "FILE", "With --link: file of known peers, the agents of the vehicles.");
    options.addResearchFlag("allow-research", "With --link: also measure insecure research suites.");
    options.addResearchFlag("allow-plain",
                            "With --link: also measure plain MAVLink ('none'); the agent must allow it as well.");
    options.addValue("suites", "LIST", "Suites to compare, separated by commas; all = every allowed suite.", "all");
    options.addResearchValue(
        "framing", "NAME",
        "Protection of MAVLink: sealed, whole frames in records; inline, payloads sealed in place (only suites "
        "of a cipher and an HMAC; the agent of --link must allow it); both of them; bare, INSECURE as in the MAVSec paper: the "
        "sweep's simulator encrypts payloads by chacha20 or aes-256-ctr alone, one way; all three.",
        "sealed");
    options.addValue("seconds", "S", "Length of each run.", "5");
    options.addValue(
        "launches", "L",
        "Number of times that all programs are started, including this station (with --link: this station only). Only "
        "launches show how results differ between starts; comparisons need 2 or more.",
        "5");
    options.addValue("repeats", "R", "Runs of each suite within each launch.", "1");
    options.addValue("warm-up", "S",
                     "Seconds before each run that are not measured; four times as many if programs have just started.", "2");
    options.addValue(
        "seed", "N",
        "Seed of the order of runs and of the impairment, to repeat a sweep. Default: drawn at random and recorded.");
    options.addValue(
        "load", "LIST",
        "natural: the streams that a station requests; saturated: as fast as possible. Default: both; with --link or --vehicle "
        "natural.");
    options.addValue(
        "pps", "LIST",
        "Additional loads in frames a second, separated by commas, on a schedule that does not "
        "depend on the station: 100,500,2000. With two or more, the CPU time is fitted as a + b frames + c wake-ups. "
        "Alone unless --load is given.");
    options.addValue("impair", "SPEC",
                     "Link condition: clean, or loss=, duplicate=, reorder=, corrupt=, delay=, jitter=, rate=, separated by "
                     "commas. May be given several times. Default: clean; with a saturated load and fewer than five cores "
                     "rate=921600, a line that can be filled there.");
    options.addValue("until", "PERCENT",
                     "Continue until the ratios to plain MAVLink in CPU time per frame, at both ends, are known to this many "
                     "percent, after 10 launches at the earliest and --launches at the latest (then 100 by default).");
    options.addFlag(
        "plan",
        "Run a few launches as a pilot (--launches, default 3) and estimate how many launches and how much time --until "
        "(default 3 %) would take.");
    options.addFlag("no-noise", "Do not measure one suite twice to estimate the machine's noise (A/A).");
    options.addFlag("noise", "Measure one suite twice even if each suite runs only once.");
    options.addValue("margin", "PERCENT",
                     "Smallest difference of practical relevance; the claims of the paper are judged by it.", "3");
    options.addValue("out", "DIR",
                     "Folder for sweep.json, sweep.csv, report.html and the figures; PNG and PDF if skyseal-figures is "
                     "installed. The files of an older sweep in it are replaced; its figures and PDF are removed first.");
    options.addValue(
        "expect", "TEXT",
        "An assertion, e.g. 'loss<=0.001' or 'cpu(aes-256-gcm)<=1.1*cpu(chacha20)'. Each side is a number or a "
        "metric with an optional factor. Without a suite or load it must hold for each. May be given several times.");
    options.addFlag("json", "One JSON object per line on stdout.");
}

/// Short enough to be typed again.
std::uint64_t drawnSeed()
{
    std::array<std::uint8_t, 4> bytes{};
    crypto::SystemRandom().fill(bytes);
    std::uint64_t out = 0;
    for (const std::uint8_t byte : bytes)
        out = out << 8 | byte;
    return out;
}

/// "3" or "3%", up to 50, as a share.
double readPercent(Options &options, const char *name, double least)
{
    constexpr double kMost = 50;
    std::string text = options.text(name);
    if (text.ends_with('%'))
        text.pop_back();
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= least && value <= kMost))
        options.fail("--" + std::string(name) + " '" + options.text(name) + "': a percentage from "
                     + experiment::readable(least) + " to 50 is expected");
    return value / 100;
}

std::vector<crypto::SuiteId> readSuites(Options &options, bool ownAgent)
{
    const bool plain = (ownAgent && kResearch) || options.has("allow-plain");
    const bool research = ownAgent || options.has("allow-research");
    std::vector<crypto::SuiteId> suites = options.suites("suites", true);
    if (options.text("suites") == "all") {
        if (plain)
            suites.insert(suites.begin(), crypto::SuiteId::None);
        std::erase_if(suites, [&](crypto::SuiteId suite) {
            return !crypto::suiteAvailable(suite) || (crypto::suiteInfo(suite).research && !research);
        });
    }
    for (const crypto::SuiteId suite : suites) {
        const std::string what = "--suites '" + std::string(crypto::suiteInfo(suite).name) + "': ";
        if (suite == crypto::SuiteId::None && !plain)
            options.fail(
                what
                + (kResearch ? "plain MAVLink must be allowed at both ends; requires --allow-plain" : "not in this build"));
        else if (crypto::suiteInfo(suite).research && !research)
            options.fail(what + "insecure, for research only; requires --allow-research");
    }
    return suites;
}

void readPaces(Options &options, experiment::Plan &plan)
{
    constexpr std::size_t kMost = 20;
    if (!options.has("pps"))
        return;
    if (!options.has("load"))
        plan.loads.clear();
    const QString text = QString::fromStdString(options.text("pps"));
    for (const QString &one : text.split(QLatin1Char(','))) {
        const auto load = experiment::loadFromName("pps" + one.trimmed().toStdString());
        if (!load || plan.loads.size() > kMost || std::ranges::find(plan.loads, *load) != plan.loads.end())
            return options.fail("--pps '" + options.text("pps") + "': up to " + std::to_string(kMost)
                                + " different rates of 1 to 1000000 are expected");
        plan.loads.push_back(*load);
    }
}

void readLoads(Options &options, bool ownVehicle, experiment::Plan &plan)
{
    const std::string text = options.has("load") ? options.text("load") : ownVehicle ? "natural,saturated" : "natural";
    if (text == "natural")
        plan.loads = {Load::Natural};
    else if (text == "saturated")
        plan.loads = {Load::Saturated};
    else if (text == "natural,saturated" || text == "saturated,natural")
        plan.loads = {Load::Natural, Load::Saturated};
    else
        options.fail("--load '" + text + "': natural, saturated or natural,saturated is expected");
    readPaces(options, plan);
    if (!ownVehicle && plan.loads != std::vector{Load::Natural})
        options.fail("--load saturated, --pps: not with --link or --vehicle, since that vehicle sets its own rates");
}

void readConditions(Options &options, bool ownAgent, SweepOptions &out)
{
    experiment::Plan &plan = out.plan;
    if (!options.has("impair")) {
        const bool isSaturated = std::ranges::find(plan.loads, Load::Saturated) != plan.loads.end();
        if (isSaturated && !experiment::placementHere().station)
            plan.conditions = {*experiment::parseCondition(kFillable)};
        return;
    }
    if (!ownAgent)
        options.fail(
            "--impair applies to the sweep's own agent; with --link use 'skyseal-cli impair' between station and agent");
    plan.conditions.clear();
    for (const std::string &text : options.texts("impair")) {
        if (auto condition = experiment::parseCondition(text))
            plan.conditions.push_back(std::move(*condition));
        else
            options.fail("--impair: " + condition.error().message.text());
    }
}

std::vector<experiment::ArmFraming> readFramings(Options &options)
{
    using experiment::ArmFraming;
    const std::string text = options.text("framing");
    if ((text == "bare" || text == "all") && (options.has("link") || options.has("vehicle")))
        options.fail("--framing " + text
                     + ": bare is for the sweep's own simulator, since no other vehicle encrypts its payloads; "
                     + "without --link and --vehicle");
    if (text == "both")
        return {ArmFraming::Sealed, ArmFraming::Inline};
    if (text == "all")
        return {std::begin(experiment::kFramings), std::end(experiment::kFramings)};
    const auto one = experiment::framingFromName(text);
    if (!one)
        options.fail("--framing '" + text + "': sealed, inline, both, bare or all is expected");
    return {one.value_or(ArmFraming::Sealed)};
}

void readSweepPlan(Options &options, bool ownAgent, SweepOptions &out)
{
    experiment::Plan &plan = out.plan;
    const std::vector<crypto::SuiteId> suites = readSuites(options, ownAgent);
    readLoads(options, ownAgent && !options.has("vehicle"), plan);
    readConditions(options, ownAgent, out);
    plan.measure = options.seconds("seconds", 0.2, 3600);
    plan.warmUp = options.seconds("warm-up", 0, 600);
    plan.launches = static_cast<unsigned>(options.wholeNumber("launches", 1, 1000));
    plan.repeats = static_cast<unsigned>(options.wholeNumber("repeats", 1, 1000));
    plan.margin = readPercent(options, "margin", 0.01);
    plan.seed = options.has("seed") ? options.wholeNumber("seed", 0, UINT64_MAX) : drawnSeed();
    const bool noise = options.has("noise") || plan.launches * plan.repeats > 1;
    plan.arms = experiment::armsOf(suites, readFramings(options), noise && !options.has("no-noise"));
    if (std::none_of(plan.arms.begin(), plan.arms.end(), experiment::exists))
        options.fail("--suites: none of them supports this framing");
}

void readVehicle(Options &options, SweepOptions &out)
{
    if (options.has("vehicle")) {
        if (options.has("link"))
            options.fail("--vehicle: not with --link, whose agent has its vehicle");
        out.vehicle = options.url("vehicle", link::LinkUrl::kLoopback);
    }
    if (!options.has("fly"))
        return;
    if (!options.has("vehicle"))
        options.fail("--fly requires --vehicle");
    auto flight = experiment::parseFlightPlan(options.text("fly"));
    if (!flight)
        return options.fail("--fly: " + flight.error().message.text());
    out.flight = std::move(*flight);
    out.plan.flight = out.flight.script;
    out.plan.phases = out.flight.phases();
    out.plan.repeats *= out.plan.phases; // of flights
}

/// The required precision, and the greatest number of launches for it.
void readGoal(Options &options, SweepOptions &out)
{
    out.forecast = options.has("plan");
    if (options.has("until"))
        out.until = readPercent(options, "until", 0.1);
    if (!options.has("launches") && out.forecast)
        out.plan.launches = kPilotLaunches;
    else if (!options.has("launches") && out.until)
        out.plan.launches = kMostLaunchesUntil;
    if (out.until && !out.forecast && out.plan.launches < experiment::kLeastLaunchesUntil)
        options.fail("--until requires --launches of 10 or more");
    if (out.forecast && out.plan.launches < 2)
        options.fail("--plan requires --launches of 2 or more");
}

void readExpectations(Options &options, SweepOptions &out)
{
    for (const std::string &text : options.texts("expect")) {
        auto parsed = experiment::Expectation::parse(text);
        if (!parsed) {
            options.fail("--expect: " + parsed.error().text());
            return;
        }
        if (const auto fit = experiment::fits(*parsed, out.plan); !fit)
            options.fail("--expect: " + fit.error().text());
        out.expectations.push_back(std::move(*parsed));
    }
}

/// See SweepOptions::repeatedBy.
QStringList repeating(const QStringList &arguments, const Options &options, const SweepOptions &read)
{
    const bool namesSuites = options.text("suites") != "all";
    QStringList out;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        if (!namesSuites && arguments[i] == QLatin1String("--suites"))
            ++i; // and its value
        else if (namesSuites || arguments[i] != QLatin1String("--suites=all"))
            out << arguments[i];
    }
    if (!namesSuites)
        out << suiteArguments(read.plan);
    if (!options.has("impair") && !read.link)
        out << linkArguments(read.plan);
    if (!options.has("seed"))
        out << QStringLiteral("--seed") << QString::number(read.plan.seed);
    return out;
}

} // namespace

std::optional<int> readSweepOptions(const QString &name, const QStringList &arguments, SweepOptions &out)
{
    Options options(name, QStringLiteral("Measures and compares the cost of each suite."));
    declareSweepOptions(options);
    if (const auto status = options.parse(arguments))
        return status;
    options.arguments(0, 0);
    const bool ownAgent = !options.has("link");
    if (!ownAgent) {
        out.link = options.url("link");
        out.station.keys = {options.required("identity"), options.required("peers")};
    }
    out.station.policy.suites = channel::defaultSuites();
    out.station.policy.allowResearch = ownAgent || options.has("allow-research");
    out.station.policy.allowPlain = ownAgent || options.has("allow-plain");
    readSweepPlan(options, ownAgent, out);
    readVehicle(options, out);
    readExpectations(options, out);
    readGoal(options, out);
    out.repeatedBy = repeating(arguments, options, out);
    out.folder = QString::fromStdString(options.text("out"));
    out.json = options.has("json");
    return options.finish();
}

} // namespace skyseal::app
