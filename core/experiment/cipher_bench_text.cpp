// JSON and text output of the benchmark of the suites.
#include "core/experiment/cipher_bench.h"

#include "core/base/json_writer.h"
#include "core/base/number_text.h"
#include "core/experiment/metric.h"

#include <algorithm>
#include <cstdio>

namespace skyseal::experiment {

namespace {

void writeCost(JsonWriter &json, std::string_view key, const CallCost &cost)
{
    json.key(key).beginObject().field("best_ns", cost.best).field("median_ns", cost.median).endObject();
}

void writeSteps(JsonWriter &json, std::string_view key, const StepCosts &steps)
{
    json.key(key).beginObject();
    writeCost(json, "cipher", steps.cipher);
    writeCost(json, "bare", steps.bare);
    writeCost(json, "suite", steps.suite);
    writeCost(json, "record", steps.record);
    json.field("record_over_bare", steps.record.best / steps.bare.best).endObject();
}

void writeBytes(JsonWriter &json, std::string_view key, const std::optional<double> &bytes)
{
    json.key(key);
    if (bytes)
        json.value(*bytes);
    else
        json.null();
}

/// A blank, and the text at the right of a column of this width.
std::string cell(const std::string &text, std::size_t width)
{
    return std::string(1 + width - std::min(width, text.size()), ' ') + text;
}

std::string stepsText(const StepCosts &steps)
{
    std::string out;
    for (const double nanoseconds : {steps.cipher.best, steps.bare.best, steps.suite.best, steps.record.best})
        out += cell(fixedText(nanoseconds, 0), 7);
    return out + cell(fixedText(steps.record.best / steps.bare.best, 2), 6);
}

} // namespace

std::vector<std::string> benchEvents(const SuiteCosts &costs, bool aes)
{
    std::vector<std::string> out;
    for (const SizeCosts &size : costs.sizes) {
        JsonWriter json;
        json.beginObject().field("event", "bench").field("suite", crypto::suiteInfo(costs.suite).name);
        json.field("aes_instructions", aes).field("size", std::uint64_t(size.size));
        writeSteps(json, "seal", size.seal);
        writeSteps(json, "open", size.open);
        writeBytes(json, "context_bytes", costs.contextBytes);
        writeBytes(json, "session_bytes", costs.sessionBytes);
        out.push_back(json.endObject().text());
    }
    return out;
}

std::vector<std::string> benchHeader()
{
    char head[160], names[160];
    std::snprintf(head, sizeof head, "%-18s %5s %38s %38s", "nanoseconds", "", "seal               ", "open               ");
    std::snprintf(names, sizeof names, "%-18s %5s %7s %7s %7s %7s %6s %7s %7s %7s %7s %6s", "suite", "bytes", "cipher", "bare",
                  "suite", "record", "x", "cipher", "bare", "suite", "record", "x");
    return {head, names};
}

std::vector<std::string> benchText(const SuiteCosts &costs)
{
    std::vector<std::string> out;
    const std::string name(crypto::suiteInfo(costs.suite).name);
    if (costs.failed)
        return {name + ": not available, or a record did not open"};
    for (const SizeCosts &size : costs.sizes) {
        char begin[48];
        std::snprintf(begin, sizeof begin, "%-18s %5zu", out.empty() ? name.c_str() : "", size.size);
        out.push_back(begin + stepsText(size.seal) + stepsText(size.open));
    }
    if (costs.contextBytes && costs.sessionBytes)
        out.push_back("                   memory: " + readable(*costs.contextBytes) + " bytes a context, "
                      + readable(*costs.sessionBytes) + " a session");
    return out;
}

} // namespace skyseal::experiment
