#include "core/experiment/sweep_json.h"

#include "core/base/json_writer.h"
#include "core/experiment/analysis.h"
#include "core/experiment/claims.h"
#include "core/experiment/contrast.h"
#include "core/experiment/cost_model.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/message_mix.h"
#include "core/experiment/relay_comparison.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

void number(JsonWriter &json, std::string_view key, double value)
{
    json.key(key);
    if (std::isfinite(value))
        json.value(value);
    else
        json.null();
}

/// Null without a test.
void verdict(JsonWriter &json, std::string_view key, const Contrast &contrast, bool holds)
{
    json.key(key);
    if (contrast.known())
        json.value(holds);
    else
        json.null();
}

void place(JsonWriter &json, const Plan &plan, std::size_t condition, std::size_t load)
{
    json.field("condition", plan.conditions[condition].name).field("load", name(plan.loads[load]));
}

void arm(JsonWriter &json, const SweepArm &arm)
{
    json.field("suite", crypto::suiteInfo(arm.suite).name).field("framing", framingName(arm)).field("again", arm.again);
}

void values(JsonWriter &json, const Values &values)
{
    json.key("values").beginObject();
    for (const MetricInfo &metric : metrics())
        number(json, metric.key, values[metric.metric]);
    json.endObject();
}

void writePlan(JsonWriter &json, const Plan &plan)
{
    json.key("plan").beginObject();
    json.key("framings").beginArray();
    for (const ArmFraming framing : framingsOf(plan))
        json.value(name(framing));
    json.endArray();
    json.field("seconds", seconds(plan.measure)).field("warm_up_seconds", seconds(plan.warmUp));
    json.field("launches", std::uint64_t(plan.launches)).field("margin", plan.margin);
    json.field("repeats", std::uint64_t(plan.repeats)).field("seed", std::to_string(plan.seed));
    if (!plan.flight.empty())
        json.field("flight", plan.flight).field("phases", std::uint64_t(plan.phases));
    json.key("arms").beginArray();
    for (const SweepArm &one : plan.arms) {
        json.beginObject();
        arm(json, one);
        json.field("insecure", isInsecure(one));
        json.field("in_framing", exists(one));
        json.endObject();
    }
    json.endArray().key("loads").beginArray();
    for (const Load load : plan.loads)
        json.value(name(load));
    json.endArray().key("conditions").beginArray();
    for (const Condition &condition : plan.conditions)
        json.value(condition.name);
    json.endArray().endObject();
}

void writeReceived(JsonWriter &json, std::string_view key, const channel::ReceiveCounters &counters)
{
    json.key(key).beginObject();
    json.field("good", counters.good).field("late", counters.late).field("lost", counters.lost);
    json.field("replayed", counters.replayed).field("forged", counters.forged).field("malformed", counters.malformed);
    json.endObject();
}

void writeDropped(JsonWriter &json, std::string_view key, const Counted::Dropped &dropped)
{
    json.key(key).beginObject().field("datagrams", dropped.datagrams);
    json.field("records", dropped.records).field("frames", dropped.frames).endObject();
}

void writeCounted(JsonWriter &json, std::string_view key, const Counted &counted)
{
    json.key(key).beginObject().key("mavlink").beginObject();
    json.field("frames", counted.mavlink.taken).field("lost", counted.mavlink.lost);
    json.field("late", counted.mavlink.late).field("duplicate", counted.mavlink.duplicate).endObject();
    writeReceived(json, "rx", counted.rx);
    writeReceived(json, "tx", counted.tx);
    if (counted.relay) {
        json.key("relay").beginObject();
        writeDropped(json, "to_station", counted.relay->toStation);
        writeDropped(json, "to_agent", counted.relay->toAgent);
        json.endObject();
    }
    json.endObject();
}

void writeRun(JsonWriter &json, const Plan &plan, const Run &run, std::size_t order)
{
    json.field("order", std::uint64_t(order));
    place(json, plan, run.condition, run.load);
    arm(json, plan.arms[run.arm]);
    json.field("launch", std::uint64_t(run.launch));
    json.field("repeat", std::uint64_t(run.repeat));
    if (!plan.flight.empty())
        json.field("phase", std::uint64_t(phaseOf(plan, run)));
}

void writeSample(JsonWriter &json, const Plan &plan, const Sample &sample)
{
    writeRun(json, plan, sample.run, sample.order);
    json.field("start", sample.start).field("seconds", sample.seconds);
    if (!sample.problem.empty())
        json.field("problem", sample.problem.text());
    if (sample.isJudged)
        json.field("valid", sample.isValid()).field("attempts", std::uint64_t(sample.attempts));
    if (!sample.invalid.empty())
        json.field("invalid", sample.invalid.text());
    if (sample.isJudged) {
        json.key("disturbances").beginArray();
        for (const std::string &text : disturbances(sample))
            json.value(text);
        json.endArray();
    }
    values(json, sample.values);
    if (sample.isCounted) {
        json.key("counted").beginObject();
        writeCounted(json, "begin", sample.begin);
        writeCounted(json, "end", sample.end);
        json.endObject();
    }
    if (!sample.messages.empty()) {
        json.key("messages").beginObject();
        for (const auto &[id, frames] : sample.messages)
            json.field(std::to_string(id), frames);
        json.endObject();
    }
    if (const auto compared = comparedWithRelay(plan, sample)) {
        json.key("relay").beginObject().field("unit", compared->unit).field("received", compared->received);
        json.field("lost", compared->lost).field("dropped", compared->dropped);
        json.field("difference", compared->difference()).endObject();
    }
}

void writeCostModel(JsonWriter &json, const Plan &plan, const CostModel &model)
{
    constexpr const char *kTerms[CostModel::kTerms] = {"constant", "per_frame", "per_wake_up"};
    json.beginObject().field("condition", plan.conditions[model.condition].name);
    arm(json, plan.arms[model.arm]);
    json.field("end", name(model.end)).field("df", model.fit.degrees);
    json.field("launches", std::uint64_t(model.launches));
    number(json, "launch_sd", model.launchDeviation);
    for (std::size_t term = 0; term < CostModel::kTerms; ++term) {
        const double value = model.fit.coefficients[term], half = model.halfWidth(term);
        json.key(kTerms[term]).beginObject();
        number(json, "ns", value);
        number(json, "ci95_low", value - half);
        number(json, "ci95_high", value + half);
        json.endObject();
    }
    number(json, "residual_sd", model.fit.deviation);
    json.key("residuals").beginArray();
    for (std::size_t i = 0; i < model.runs.size(); ++i) {
        json.beginObject().field("order", std::uint64_t(model.runs[i]->order));
        number(json, "measured", model.values[i]);
        number(json, "residual", model.fit.residuals[i]);
        json.endObject();
    }
    json.endArray().endObject();
}

void writeSummary(JsonWriter &json, const Results &results, const Cell &cell, Metric metric)
{
    const Summary summary = summaryOf(results, cell, metric);
    if (summary.count == 0)
        return;
    json.beginObject();
    place(json, results.plan, cell.condition, cell.load);
    arm(json, results.plan.arms[cell.arm]);
    json.field("metric", info(metric).key).field("n", std::uint64_t(summary.count));
    number(json, "mean", summary.mean);
    number(json, "sd", summary.deviation);
    number(json, "ci95_low", summary.low());
    number(json, "ci95_high", summary.high());
    number(json, "min", summary.min);
    number(json, "max", summary.max);
    number(json, "median", summary.median);
    const std::vector<unsigned> orders = ordersOf(results, cell);
    json.key("outliers").beginArray();
    for (const std::size_t index : summary.outliers)
        json.value(std::uint64_t(orders[index]));
    json.endArray().endObject();
}

void writeContrast(JsonWriter &json, const Plan &plan, const Contrast &contrast)
{
    const SweepArm &first = plan.arms[contrast.first], &second = plan.arms[contrast.second];
    json.beginObject();
    place(json, plan, contrast.condition, contrast.load);
    json.field("metric", info(contrast.metric).key);
    json.field("first", crypto::suiteInfo(first.suite).name).field("first_framing", framingName(first));
    json.field("second", crypto::suiteInfo(second.suite).name).field("second_framing", framingName(second));
    json.field("first_mean", contrast.firstMean).field("second_mean", contrast.secondMean);
    number(json, contrast.relative ? "ratio" : "difference", contrast.value());
    number(json, "ci95_low", contrast.low());
    number(json, "ci95_high", contrast.high());
    number(json, contrast.relative ? "log_ratio" : "estimate", contrast.estimate);
    number(json, "error", contrast.error);
    number(json, "df", contrast.degrees);
    json.field("units", std::uint64_t(contrast.units)).field("unit", contrast.ofLaunches ? "launch" : "block");
    number(json, "p", contrast.p);
    number(json, "p_holm", contrast.adjusted);
    number(json, "step", contrast.step);
    verdict(json, "significant", contrast, contrast.significant());
    verdict(json, "significant_alone", contrast, contrast.significantAlone());
    json.endObject();
}

/// Of each load that has one. Not written for sweeps of versions that did not count the messages.
void writeMessageMix(JsonWriter &json, const Results &results)
{
    if (std::ranges::all_of(results.samples, [](const Sample &sample) { return sample.messages.empty(); }))
        return;
    json.key("message_mix").beginArray();
    for (std::size_t load = 0; load < results.plan.loads.size(); ++load) {
        const MessageMix mix = messageMixOf(results, load);
        if (mix.empty())
            continue;
        json.beginObject().field("load", name(results.plan.loads[load])).key("share").beginObject();
        for (const auto &[id, share] : mix)
            json.field(std::to_string(id), share);
        json.endObject().endObject();
    }
    json.endArray();
}

void writeVerdict(JsonWriter &json, const Plan &plan, const Verdict &verdict)
{
    json.field("expectation", verdict.expectation).field("condition", plan.conditions[verdict.condition].name);
    if (!verdict.suite.empty())
        json.field("suite", verdict.suite);
    if (verdict.load)
        json.field("load", name(plan.loads[*verdict.load]));
    number(json, "left", verdict.outcome.left);
    number(json, "right", verdict.outcome.right);
    json.field("measured", verdict.outcome.measured).field("holds", verdict.outcome.holds);
}

} // namespace

std::string sweepJson(const Results &results, const std::vector<Verdict> &verdicts)
{
    const Plan &plan = results.plan;
    JsonWriter json;
    json.beginObject().field("schema", "skyseal-sweep").field("schema_version", kSweepSchemaVersion);
    json.field("complete", results.complete).field("duration", results.seconds);
    json.key("setting").beginObject();
    for (const auto &[key, value] : results.setting)
        json.field(key, value);
    json.endObject();
    json.key("setting_keys").beginArray();
    for (const auto &[key, value] : results.setting)
        json.value(key);
    json.endArray();
    if (!results.placement.empty())
        json.field("placement", results.placement);
    if (!results.source.empty())
        json.field("source", results.source);
    if (!results.unknown.empty()) {
        json.key("unknown").beginArray();
        for (const std::string &text : results.unknown)
            json.value(text);
        json.endArray();
    }
    writePlan(json, plan);
    json.key("context_bytes").beginObject();
    for (const auto &[suite, bytes] : results.contextBytes)
        json.field(crypto::suiteInfo(suite).name, bytes);
    json.endObject();
    writeMessageMix(json, results);
    json.key("metrics").beginArray();
    for (const MetricInfo &metric : metrics()) {
        json.beginObject().field("key", metric.key).field("title", metric.title.english()).field("unit", metric.unit);
        json.field("what", metric.description.english()).endObject();
    }
    json.endArray().key("samples").beginArray();
    for (const Sample &sample : results.samples) {
        json.beginObject();
        writeSample(json, plan, sample);
        json.endObject();
    }
    json.endArray().key("summaries").beginArray();
    for (const Cell &cell : cells(plan)) {
        for (const MetricInfo &metric : metrics())
            writeSummary(json, results, cell, metric.metric);
    }
    json.endArray().key("comparisons").beginArray();
    forEachPlace(plan, [&](std::size_t condition, std::size_t load) {
        for (const MetricInfo &metric : metrics())
            for (const Contrast &contrast : plannedContrasts(results, condition, load, metric.metric))
                writeContrast(json, plan, contrast);
    });
    json.endArray().key("noise").beginArray();
    for (const Contrast &noise : noiseContrasts(results))
        writeContrast(json, plan, noise);
    json.endArray().key("trends").beginArray();
    for (const OrderTrend &trend : orderTrends(results)) {
        json.beginObject();
        place(json, plan, trend.condition, trend.load);
        json.field("metric", info(trend.metric).key);
        number(json, "change_per_run", trend.perRun);
        number(json, "p_holm", trend.p);
        json.field("remains", trend.remains()).endObject();
    }
    json.endArray().key("expectations").beginArray();
    for (const Verdict &verdict : verdicts) {
        json.beginObject();
        writeVerdict(json, plan, verdict);
        json.endObject();
    }
    json.endArray().key("cost_models").beginArray();
    for (const CostModel &model : costModels(results))
        writeCostModel(json, plan, model);
    json.endArray().key("claims").beginArray();
    for (const Claim &claim : paperClaims(results)) {
        json.beginObject().field("key", claim.key).field("claim", claim.text);
        json.field("finding", findingText(claim.finding)).field("because", claim.reason);
        number(json, "decidable_margin", claim.decidable);
        number(json, "decidable_below", claim.decidableBelow);
        json.key("ratios").beginArray();
        for (const ClaimRatio &one : claim.ratios) {
            json.beginObject().field("first", one.first).field("second", one.second);
            number(json, "ratio", one.ratio);
            number(json, "ci95_low", one.low);
            number(json, "ci95_high", one.high);
            json.endObject();
        }
        json.endArray().endObject();
    }
    return json.endArray().endObject().text();
}

std::string beginEvent(const Plan &plan, const Run &run, std::size_t order)
{
    JsonWriter json;
    json.beginObject().field("event", "begin");
    writeRun(json, plan, run, order);
    return json.endObject().text();
}

std::string runEvent(const Plan &plan, const Sample &sample, std::size_t runs, double remaining)
{
    JsonWriter json;
    json.beginObject().field("event", "run").field("runs", std::uint64_t(runs)).field("remaining", remaining);
    writeSample(json, plan, sample);
    return json.endObject().text();
}

std::string endEvent(const Results &results, bool opened, const std::string &problem, const IdlePower &idle)
{
    JsonWriter json;
    json.beginObject().field("event", "end").field("opened", opened).field("complete", results.complete);
    json.field("duration", results.seconds);
    if (!results.placement.empty())
        json.field("placement", results.placement);
    if (!results.source.empty())
        json.field("source", results.source);
    if (idle.isKnown())
        json.field("idle_before", idle.before).field("idle_after", idle.after);
    if (!problem.empty())
        json.field("problem", problem);
    return json.endObject().text();
}

std::string expectEvent(const Plan &plan, const Verdict &verdict)
{
    JsonWriter json;
    json.beginObject().field("event", "expect");
    writeVerdict(json, plan, verdict);
    return json.endObject().text();
}

} // namespace skyseal::experiment
