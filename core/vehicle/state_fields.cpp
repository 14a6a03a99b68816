#include "core/vehicle/state_fields.h"

#include "core/base/ascii.h"

namespace skyseal::vehicle {

namespace {

using Kind = StateField::Kind;
using State = VehicleState;

double orUnknown(int value)
{
    return value < 0 ? kUnknown : value;
}

// Readers of the statistics rely on the first sixteen.
constexpr StateField kFields[] = {
    {"sysid", "", Kind::Integer, [](const State &s) -> double { return s.systemId; }},
    {"mode", "", Kind::Text, nullptr, [](const State &s) -> const std::string & { return s.mode; }},
    {"armed", "", Kind::Flag, [](const State &s) -> double { return s.armed; }},
    {"roll", "rad", Kind::Number, [](const State &s) { return s.roll; }},
    {"pitch", "rad", Kind::Number, [](const State &s) { return s.pitch; }},
    {"yaw", "rad", Kind::Number, [](const State &s) { return s.yaw; }},
    {"lat", "deg", Kind::Number, [](const State &s) { return s.position.latitude; }},
    {"lon", "deg", Kind::Number, [](const State &s) { return s.position.longitude; }},
    {"alt_rel", "m", Kind::Number, [](const State &s) { return s.altitudeRelative; }},
    {"ground_speed", "m/s", Kind::Number, [](const State &s) { return s.groundSpeed; }},
    {"battery_v", "V", Kind::Number, [](const State &s) { return s.batteryVoltage; }},
    {"battery_percent", "%", Kind::Number, [](const State &s) { return s.batteryPercent; }},
    {"gps_fix", "", Kind::Integer, [](const State &s) { return orUnknown(s.gpsFix); }},
    {"satellites", "", Kind::Integer, [](const State &s) { return orUnknown(s.satellites); }},
    {"ekf_ok", "", Kind::Integer, [](const State &s) { return s.ekfOk ? double(*s.ekfOk) : kUnknown; }},
    {"heartbeat_age", "s", Kind::Number, [](const State &s) { return s.heartbeatAge; }},
    {"alt", "m", Kind::Number, [](const State &s) { return s.position.altitude; }},
    {"climb", "m/s", Kind::Number, [](const State &s) { return s.climb; }},
    {"heading", "deg", Kind::Number, [](const State &s) { return s.heading; }},
    {"air_speed", "m/s", Kind::Number, [](const State &s) { return s.airSpeed; }},
    {"throttle", "%", Kind::Number, [](const State &s) { return s.throttle; }},
    {"battery_a", "A", Kind::Number, [](const State &s) { return s.batteryCurrent; }},
    {"hdop", "", Kind::Number, [](const State &s) { return s.hdop; }},
    {"distance_home", "m", Kind::Number, [](const State &s) { return s.distanceHome; }},
    {"flight_time", "s", Kind::Number, [](const State &s) { return s.flightTime; }},
    {"mission_current", "", Kind::Integer, [](const State &s) { return orUnknown(s.missionCurrent); }},
    {"custom_mode", "", Kind::Integer, [](const State &s) -> double { return s.customMode; }},
    {"system_status", "", Kind::Integer, [](const State &s) -> double { return s.systemStatus; }},
    {"cpu_load", "%", Kind::Number, [](const State &s) { return s.cpuLoad; }},
    {"vibration", "m/s/s", Kind::Number, [](const State &s) { return s.vibration; }},
    {"latency", "s", Kind::Number, [](const State &s) { return s.latency; }},
    {"message_age", "s", Kind::Number, [](const State &s) { return s.messageAge; }},
    {"lost", "", Kind::Flag, [](const State &s) -> double { return s.lost; }},
    {"radio_signal", "", Kind::Integer, [](const State &s) { return s.radio.signal; }},
    {"radio_remote_signal", "", Kind::Integer, [](const State &s) { return s.radio.remoteSignal; }},
    {"radio_noise", "", Kind::Integer, [](const State &s) { return s.radio.noise; }},
    {"radio_remote_noise", "", Kind::Integer, [](const State &s) { return s.radio.remoteNoise; }},
    {"radio_buffer", "%", Kind::Integer, [](const State &s) { return s.radio.buffer; }},
    {"firmware", "", Kind::Text, nullptr, [](const State &s) -> const std::string & { return s.firmware; }},
};

void writeNumber(JsonWriter &json, double value)
{
    if (std::isfinite(value))
        json.value(value);
    else
        json.null();
}

void writeBatteries(JsonWriter &json, const VehicleState &state)
{
    json.key("batteries").beginArray();
    for (const Battery &battery : state.batteries) {
        json.beginObject().field("id", std::uint32_t{battery.id}).field("function", std::uint32_t{battery.function});
        writeNumber(json.key("v"), battery.voltage);
        writeNumber(json.key("a"), battery.current);
        writeNumber(json.key("percent"), battery.percent);
        json.endObject();
    }
    json.endArray();
}

} // namespace

std::span<const StateField> stateFields()
{
    return kFields;
}

const StateField *findStateField(std::string_view name)
{
    for (const StateField &field : kFields) {
        if (equalIgnoringCase(field.name, name))
            return &field;
    }
    return nullptr;
}

void writeStateFields(JsonWriter &json, const VehicleState &state)
{
    for (const StateField &field : kFields) {
        json.key(field.name);
        if (field.kind == Kind::Text) {
            json.value(std::string_view(field.text(state)));
            continue;
        }
        const double value = field.number(state);
        if (!std::isfinite(value))
            json.null();
        else if (field.kind == Kind::Flag)
            json.value(value != 0);
        else if (field.kind == Kind::Integer)
            json.value(static_cast<std::int64_t>(value));
        else
            json.value(value);
    }
    writeBatteries(json, state);
}

} // namespace skyseal::vehicle
