#include "core/engine/headless/telemetry_csv.h"

#include "core/base/number_text.h"
#include "core/base/printable.h"
#include "core/log/log_reader.h"
#include "core/log/log_time.h"
#include "core/vehicle/state_fields.h"
#include "core/vehicle/vehicle_set.h"

#include <cmath>
#include <map>
#include <optional>

namespace skyseal::engine {

namespace {

/// Position 0 of a recording as a time for the vehicles; their clock has no meaningful zero.
constexpr TimePoint kBeginning{std::chrono::hours(1)};

/// RFC 4180: quoted if it contains a comma, a quote or a line end.
std::string quoted(const std::string &text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string out = "\"";
    for (const char c : text)
        out.append(c == '"' ? 2 : 1, c);
    return out + "\"";
}

std::string headLine()
{
    std::string out = "time";
    for (const vehicle::StateField &field : vehicle::stateFields())
        out.append(",").append(field.name);
    return out;
}

std::string rowOf(WallTime time, const vehicle::VehicleState &state)
{
    std::string out = numberText(static_cast<double>(time.time_since_epoch().count()) / 1e6);
    for (const vehicle::StateField &field : vehicle::stateFields()) {
        out += ',';
        if (field.kind == vehicle::StateField::Kind::Text)
            out += quoted(printable(field.text(state)));
        else if (const double value = field.number(state); !std::isnan(value))
            out += numberText(value);
    }
    return out;
}

} // namespace

std::uint64_t exportTelemetry(std::istream &input, const mavlink::Dialect &dialect, Duration every,
                              const std::function<bool(const std::string &line)> &sink)
{
    vehicle::VehicleConfig config;
    config.streams = vehicle::StreamProfile::Quiet;
    vehicle::VehicleSet vehicles(config);
    std::map<std::uint8_t, WallTime> latestRow; // by system
    std::uint64_t rows = 0;
    const auto pace = std::chrono::duration_cast<std::chrono::microseconds>(every);

    tlog::LogReader reader(input, dialect);
    tlog::LogTime line;
    std::optional<WallTime> time; // of an entry whose own is damaged, that of the one before
    if (!sink(headLine()))
        return rows;
    while (const auto item = reader.next()) {
        // The vehicles' clock is the line of the recording: it does not step when the clock was set.
        const TimePoint now = kBeginning + line.note(item->time);
        if (item->time)
            time = item->time;
        if (!item->frame || !time)
            continue;
        vehicles.handleFrame(now, *time, *item->frame);
        vehicle::Vehicle *vehicle = vehicles.find(item->frame->systemId());
        if (!vehicle)
            continue;
        while (vehicle->pollOutgoing()) {}
        while (vehicle->pollEvent()) {}
        const auto [latest, isFirst] = latestRow.try_emplace(vehicle->systemId(), *time);
        if (!isFirst && *time >= latest->second && *time - latest->second < pace)
            continue;
        latest->second = *time;
        if (!sink(rowOf(*time, vehicle->state(now))))
            return rows;
        ++rows;
    }
    return rows;
}

} // namespace skyseal::engine
