#include "core/experiment/sweep_reader.h"

#include "core/experiment/expectation.h"
#include "core/experiment/sweep_json.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace skyseal::experiment {

namespace {

constexpr qsizetype kMostBytes = 256 << 20, kMostSamples = 1'000'000, kMostArms = 64, kMostPlaces = 64, kMostLoads = 64,
                    kMostExpectations = 1000;

QLatin1String q(const char *key)
{
    return QLatin1String(key);
}

std::string textOf(const QJsonValue &value)
{
    return value.toString().toStdString();
}

double numberOf(const QJsonValue &value)
{
    return value.toDouble(std::numeric_limits<double>::quiet_NaN());
}

std::uint64_t countOf(const QJsonValue &value)
{
    return static_cast<std::uint64_t>(std::max<qint64>(value.toInteger(), 0));
}

Duration durationOf(const QJsonValue &value)
{
    constexpr double kMost = 1e7;
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(std::clamp(value.toDouble(), 0.0, kMost)));
}

/// Version 1 knew one framing, which stands in the plan and in no arm.
std::optional<SweepArm> armOf(const QJsonObject &object)
{
    const auto suite = crypto::suiteFromName(textOf(object[q("suite")]));
    if (!suite)
        return std::nullopt;
    const std::string framing = textOf(object[q("framing")]);
    const SweepArm out{*suite, object[q("again")].toBool(), framingFromName(framing).value_or(ArmFraming::Sealed)};
    if (object.contains(q("framing")) && framing != framingName(out))
        return std::nullopt;
    return out;
}

InputError wrong(const std::string &what)
{
    return InputError{"not the sweep.json of a sweep: " + what, {}};
}

Result<Plan, InputError> planOf(const QJsonObject &object)
{
    Plan out;
    out.loads.clear();
    out.conditions.clear();
    const bool hasOneFraming = textOf(object[q("framing")]) == "sealed"; // version 1
    for (const QJsonValue one : object[q("arms")].toArray()) {
        const auto arm = armOf(one.toObject());
        if (!arm || (!hasOneFraming && !one.toObject().contains(q("framing"))))
            return tl::unexpected(wrong("an arm of the plan is unknown"));
        out.arms.push_back(*arm);
    }
    for (const QJsonValue one : object[q("loads")].toArray()) {
        const auto load = loadFromName(textOf(one));
        if (!load)
            return tl::unexpected(wrong("a load of the plan is unknown"));
        out.loads.push_back(*load);
    }
    for (const QJsonValue one : object[q("conditions")].toArray()) {
        auto condition = parseCondition(textOf(one));
        if (!condition)
            return tl::unexpected(wrong("condition " + condition.error().text()));
        out.conditions.push_back(std::move(*condition));
    }
    for (const auto &[size, most] : {std::pair(out.arms.size(), kMostArms), std::pair(out.loads.size(), kMostLoads),
                                     std::pair(out.conditions.size(), kMostPlaces)}) {
        if (size == 0 || size > static_cast<std::size_t>(most))
            return tl::unexpected(wrong("its plan has no arms, loads or conditions, or too many"));
    }
    constexpr qint64 kMostRepeats = 100000;
    out.measure = durationOf(object[q("seconds")]);
    out.warmUp = durationOf(object[q("warm_up_seconds")]);
    out.repeats = static_cast<unsigned>(std::clamp<qint64>(object[q("repeats")].toInteger(), 1, kMostRepeats));
    out.launches = static_cast<unsigned>(std::clamp<qint64>(object[q("launches")].toInteger(1), 1, kMostRepeats));
    out.flight = textOf(object[q("flight")]);
    out.phases = static_cast<unsigned>(std::clamp<qint64>(object[q("phases")].toInteger(1), 1, kMostRepeats));
    if (out.measure <= Duration::zero() || qint64(out.repeats) * out.launches > kMostSamples)
        return tl::unexpected(wrong("its plan has no duration, or too many runs"));
    if (const double margin = object[q("margin")].toDouble(out.margin); margin > 0 && margin < 1)
        out.margin = margin;
    const std::string seed = textOf(object[q("seed")]);
    std::from_chars(seed.data(), seed.data() + seed.size(), out.seed);
    return out;
}

channel::ReceiveCounters receivedOf(const QJsonObject &object)
{
    channel::ReceiveCounters out;
    out.good = countOf(object[q("good")]);
    out.late = countOf(object[q("late")]);
    out.lost = countOf(object[q("lost")]);
    out.replayed = countOf(object[q("replayed")]);
    out.forged = countOf(object[q("forged")]);
    out.malformed = countOf(object[q("malformed")]);
    return out;
}

Counted::Dropped droppedOf(const QJsonValue &value)
{
    return {countOf(value[q("datagrams")]), countOf(value[q("records")]), countOf(value[q("frames")])};
}

Counted countedOf(const QJsonObject &object)
{
    Counted out;
    const QJsonObject frames = object[q("mavlink")].toObject();
    out.mavlink.taken = countOf(frames[q("frames")]);
    out.mavlink.lost = countOf(frames[q("lost")]);
    out.mavlink.late = countOf(frames[q("late")]);
    out.mavlink.duplicate = countOf(frames[q("duplicate")]);
    out.rx = receivedOf(object[q("rx")].toObject());
    out.tx = receivedOf(object[q("tx")].toObject());
    if (const QJsonValue relay = object[q("relay")]; relay.isObject())
        out.relay = Counted::Relay{droppedOf(relay[q("to_station")]), droppedOf(relay[q("to_agent")])};
    return out;
}

/// Message ids have 24 bits. A sweep of a version that did not count them has none.
std::map<std::uint32_t, std::uint64_t> messagesOf(const QJsonObject &object)
{
    constexpr qsizetype kMostMessages = 4096;
    constexpr std::uint32_t kMostId = 0xffffff;
    std::map<std::uint32_t, std::uint64_t> out;
    for (auto at = object.begin(); at != object.end() && qsizetype(out.size()) < kMostMessages; ++at) {
        bool isNumber = false;
        const std::uint32_t id = at.key().toUInt(&isNumber);
        if (isNumber && id <= kMostId)
            out[id] = countOf(at.value());
    }
    return out;
}

/// An object loses the order of its keys, which the report shows; so the keys are listed as well.
Setting settingOf(const QJsonObject &report)
{
    Setting out;
    const QJsonObject setting = report[q("setting")].toObject();
    QStringList keys;
    for (const QJsonValue key : report[q("setting_keys")].toArray())
        keys << key.toString();
    if (keys.isEmpty())
        keys = setting.keys();
    for (const QString &key : keys)
        out.emplace_back(key.toStdString(), textOf(setting[key]));
    return out;
}

} // namespace

std::optional<Run> readRun(const QJsonObject &object, const Plan &plan)
{
    const auto arm = armOf(object);
    const auto load = loadFromName(textOf(object[q("load")]));
    if (!arm || !load)
        return std::nullopt;
    const auto foundArm = std::ranges::find(plan.arms, *arm);
    const auto foundLoad = std::ranges::find(plan.loads, *load);
    const auto foundCondition = std::ranges::find(plan.conditions, textOf(object[q("condition")]), &Condition::name);
    const qint64 repeat = object[q("repeat")].toInteger(), launch = object[q("launch")].toInteger(0);
    if (foundArm == plan.arms.end() || foundLoad == plan.loads.end() || foundCondition == plan.conditions.end() || repeat < 0
        || repeat >= plan.repeats || launch < 0 || launch >= plan.launches)
        return std::nullopt;
    return Run{static_cast<std::size_t>(foundCondition - plan.conditions.begin()),
               static_cast<std::size_t>(foundLoad - plan.loads.begin()), static_cast<std::size_t>(foundArm - plan.arms.begin()),
               static_cast<unsigned>(repeat), static_cast<unsigned>(launch)};
}

std::optional<Sample> readSample(const QJsonObject &object, const Plan &plan)
{
    const std::optional<Run> run = readRun(object, plan);
    if (!run)
        return std::nullopt;
    Sample out;
    out.run = *run;
    out.order = static_cast<unsigned>(std::clamp<qint64>(object[q("order")].toInteger(), 0, kMostSamples));
    out.start = object[q("start")].toDouble();
    out.seconds = object[q("seconds")].toDouble();
    out.problem = textOf(object[q("problem")]);
    out.invalid = textOf(object[q("invalid")]);
    out.attempts = static_cast<unsigned>(std::clamp<qint64>(object[q("attempts")].toInteger(1), 1, 1000));
    out.isJudged = object.contains(q("valid"));
    out.isCounted = object[q("counted")].isObject();
    const QJsonObject values = object[q("values")].toObject();
    for (const MetricInfo &metric : metrics())
        out.values[metric.metric] = numberOf(values[QLatin1String(metric.key.data(), qsizetype(metric.key.size()))]);
    out.begin = countedOf(object[q("counted")][q("begin")].toObject());
    out.end = countedOf(object[q("counted")][q("end")].toObject());
    out.messages = messagesOf(object[q("messages")].toObject());
    return out;
}

namespace {

/// For a report: what a file does not hold, since its version did not or the programs that wrote it measured less.
std::vector<std::string> unknownIn(const QJsonObject &report, unsigned version, const std::vector<Sample> &samples)
{
    std::vector<std::string> out;
    for (const QJsonValue text : report[q("unknown")].toArray())
        out.push_back(textOf(text));
    if (version == kSweepSchemaVersion)
        return out;
    const std::string older = "This sweep was recorded in version " + std::to_string(version) + " of the file. ";
    if (!std::ranges::any_of(samples, &Sample::isJudged))
        out.push_back(older
                      + "It does not state whether a run carried its load and what disturbed it: each run without a problem "
                        "counts, and a saturated load may have been less.");
    if (!std::ranges::any_of(samples, &Sample::isCounted))
        out.push_back(
            older
            + "Its counters of records are unknown: where no record was lost, the share that may have been lost has the "
              "upper bound of 100 %.");
    std::string missing;
    const QJsonArray runs = report[q("samples")].toArray();
    for (const MetricInfo &metric : metrics()) {
        const QLatin1String key(metric.key.data(), qsizetype(metric.key.size()));
        const auto has = [key](const QJsonValue &run) { return run[q("values")].toObject().contains(key); };
        if (std::none_of(runs.begin(), runs.end(), has))
            missing.append(missing.empty() ? "" : ", ").append(metric.key);
    }
    for (const char *key : {"context_bytes", "placement", "source"})
        missing += report.contains(q(key)) ? "" : (missing.empty() ? "" : ", ") + std::string(key);
    if (!missing.empty())
        out.push_back(older + "Not recorded, and therefore empty: " + missing + ".");
    constexpr unsigned kFirstWithoutProbes = 3;
    if (version < kFirstWithoutProbes)
        out.push_back(older
                      + "The CPU load of its station includes the snapshots of the measurement itself, and that of its agent "
                        "has two sources, the kernel for plain MAVLink and the agent's reports for the others: its ratios to "
                        "plain MAVLink are not those of later sweeps.");
    return out;
}

} // namespace

Result<ReadSweep, InputError> readSweep(const QByteArray &json)
{
    if (json.size() > kMostBytes)
        return tl::unexpected(wrong("it is larger than 256 MB"));
    const QJsonObject report = QJsonDocument::fromJson(json).object();
    if (textOf(report[q("schema")]) != "skyseal-sweep")
        return tl::unexpected(wrong("it has another schema, or is damaged"));
    ReadSweep out;
    out.schemaVersion = static_cast<unsigned>(std::clamp<qint64>(report[q("schema_version")].toInteger(), 0, 1000));
    if (out.schemaVersion < kOldestReadableSweep || out.schemaVersion > kSweepSchemaVersion)
        return tl::unexpected(wrong("its version is " + std::to_string(out.schemaVersion) + ", and versions "
                                    + std::to_string(kOldestReadableSweep) + " to " + std::to_string(kSweepSchemaVersion)
                                    + " can be read"));
    auto plan = planOf(report[q("plan")].toObject());
    if (!plan)
        return tl::unexpected(plan.error());
    Results &results = out.results;
    results.plan = std::move(*plan);
    results.setting = settingOf(report);
    results.placement = textOf(report[q("placement")]);
    results.source = textOf(report[q("source")]);
    results.complete = report[q("complete")].toBool();
    results.seconds = report[q("duration")].toDouble();
    const QJsonObject contexts = report[q("context_bytes")].toObject();
    for (auto at = contexts.begin(); at != contexts.end(); ++at) {
        if (const auto suite = crypto::suiteFromName(at.key().toStdString()); suite && at.value().isDouble())
            results.contextBytes[*suite] = at.value().toDouble();
    }
    const QJsonArray samples = report[q("samples")].toArray();
    if (samples.size() > kMostSamples)
        return tl::unexpected(wrong("it has too many runs"));
    for (const QJsonValue one : samples) {
        auto sample = readSample(one.toObject(), results.plan);
        if (!sample || (out.schemaVersion > 1 && !one.toObject().contains(q("framing"))))
            return tl::unexpected(wrong("a run is not one of its plan"));
        results.samples.push_back(std::move(*sample));
    }
    results.unknown = unknownIn(report, out.schemaVersion, results.samples);
    for (const QJsonValue one : report[q("expectations")].toArray()) {
        const std::string text = textOf(one[q("expectation")]);
        const auto parsed = Expectation::parse(text);
        if (!parsed || qsizetype(out.expectations.size()) > kMostExpectations)
            return tl::unexpected(wrong("an assertion cannot be read"));
        if (std::ranges::find(out.expectations, text) == out.expectations.end())
            out.expectations.push_back(text);
    }
    return out;
}

} // namespace skyseal::experiment
