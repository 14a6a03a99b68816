#include "core/engine/headless/open_metrics.h"

#include "core/base/number_text.h"
#include "core/crypto/suite.h"
#include "core/engine/station/snapshot.h"
#include "core/vehicle/state_fields.h"

#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace skyseal::engine {

namespace {

struct Label
{
    std::string_view name;
    std::string value;
};
using Labels = std::initializer_list<Label>;

/// Writes metric families one after the other: the format requires the samples of a family to be contiguous.
class Exposition
{
public:
    void counter(std::string_view name, std::string_view help) { family(name, "counter", "_total", help); }
    void gauge(std::string_view name, std::string_view help) { family(name, "gauge", "", help); }

    void sample(Labels labels, std::uint64_t value) { write(labels, std::to_string(value)); }
    /// Omitted if the value is unknown.
    void sample(Labels labels, double value)
    {
        if (std::isfinite(value))
            write(labels, numberText(value));
    }

    std::string end() &&
    {
        m_text += "# EOF\n";
        return std::move(m_text);
    }

private:
    void family(std::string_view name, std::string_view type, std::string_view suffix, std::string_view help)
    {
        m_family = "skyseal_" + std::string(name);
        m_suffix = suffix;
        m_text += "# TYPE " + m_family + ' ' + std::string(type) + "\n# HELP " + m_family + ' ' + std::string(help) + '\n';
    }

    void write(Labels labels, const std::string &value)
    {
        m_text += m_family + m_suffix;
        char before = '{';
        for (const Label &label : labels) {
            m_text += std::exchange(before, ',') + std::string(label.name) + "=\"";
            for (const char c : label.value) {
                if (c == '\\' || c == '"')
                    m_text += '\\';
                m_text += c == '\n' ? std::string("\\n") : std::string(1, c);
            }
            m_text += '"';
        }
        m_text += (labels.size() ? "} " : " ") + value + '\n';
    }

    std::string m_text, m_family, m_suffix;
};

std::string systemOf(const VehicleSnapshot &vehicle)
{
    return std::to_string(vehicle.state.systemId);
}

void writeLink(Exposition &out, const Snapshot &snapshot)
{
    const MavlinkTotals &mavlink = snapshot.mavlink;
    out.counter("mavlink_frames", "Accepted MAVLink frames of vehicles.");
    out.sample({}, mavlink.frames);
    out.counter("mavlink_frames_missing", "MAVLink frames that are missing by their sequence numbers.");
    out.sample({}, mavlink.lost);
    out.counter("mavlink_frames_damaged", "MAVLink frames with a wrong checksum.");
    out.sample({}, mavlink.badCrc);
    out.counter("records", "Sealed records that were received, by what became of them.");
    const channel::ReceiveCounters &rx = snapshot.channel.rx;
    const std::pair<const char *, std::uint64_t> outcomes[] = {
        {"good", rx.good}, {"lost", rx.lost}, {"replayed", rx.replayed}, {"forged", rx.forged}, {"malformed", rx.malformed}};
    for (const auto &[outcome, count] : outcomes)
        out.sample({{"outcome", outcome}}, count);
    out.counter("plaintext_frames_refused", "Plain MAVLink frames that were refused.");
    out.sample({}, snapshot.plaintextRefused);
    out.counter("system_frames_refused", "Sealed frames with a system ID that their peer may not use.");
    out.sample({}, snapshot.spoofed);
    out.counter("other_system_frames", "Sealed frames of systems behind an agent that belong to no peer.");
    for (const OtherSystemsHeard &heard : snapshot.otherSystems)
        out.sample({{"peer", heard.peer}}, heard.frames);
    out.counter("events_dropped", "Events that were dropped because this program did not keep up.");
    out.sample({}, snapshot.eventsDropped);
}

void writeSessions(Exposition &out, const Snapshot &snapshot)
{
    out.gauge("session_epoch", "Epoch of a session that is up: it rises with each switch and change of keys.");
    for (const SessionSnapshot &session : snapshot.sessions)
        out.sample({{"peer", session.info.peerName}, {"suite", std::string(crypto::suiteInfo(session.info.suite).name)}},
                   static_cast<std::uint64_t>(session.info.epoch));
    out.gauge("session_under_attack", "1 if records of the last minute were forged, or replayed more often than networks do.");
    for (const SessionSnapshot &session : snapshot.sessions)
        out.sample({{"peer", session.info.peerName}}, std::uint64_t(isAttacked(session)));
}

void writeVehicles(Exposition &out, const Snapshot &snapshot)
{
    out.gauge("vehicle_heard", "1 while frames of the vehicle arrive.");
    for (const VehicleSnapshot &vehicle : snapshot.vehicles)
        out.sample({{"sysid", systemOf(vehicle)}}, std::uint64_t(!vehicle.state.lost));
    out.gauge("vehicle_sealed", "1 if the vehicle was last heard over a session.");
    for (const VehicleSnapshot &vehicle : snapshot.vehicles)
        out.sample({{"sysid", systemOf(vehicle)}}, std::uint64_t(vehicle.session.has_value()));
    for (const vehicle::StateField &field : vehicle::stateFields()) {
        if (field.kind == vehicle::StateField::Kind::Text || field.name == "sysid") // the label
            continue;
        const std::string unit = field.unit.empty() ? std::string() : " (" + std::string(field.unit) + ")";
        out.gauge("vehicle_" + std::string(field.name), "State of the vehicle" + unit + ".");
        for (const VehicleSnapshot &vehicle : snapshot.vehicles)
            out.sample({{"sysid", systemOf(vehicle)}}, field.number(vehicle.state));
    }
}

void writeClients(Exposition &out, const Snapshot &snapshot)
{
    const std::pair<const char *, std::uint64_t ClientCounters::*> outcomes[] = {
        {"forwarded", &ClientCounters::forwarded},
        {"denied", &ClientCounters::denied},
        {"too_often", &ClientCounters::tooOften},
        {"not_its_system", &ClientCounters::notItsSystem}};
    out.counter("client_frames", "Frames of the gateway's clients, by what became of them.");
    for (const ClientSnapshot &client : snapshot.clients) {
        for (const auto &[outcome, count] : outcomes)
            out.sample({{"client", client.name}, {"address", client.address}, {"outcome", outcome}}, client.counters.*count);
    }
}

void writeBroker(Exposition &out, const mqtt::PublisherStatus &broker)
{
    out.gauge("mqtt_connected", "1 while the MQTT broker accepts messages.");
    out.sample({}, std::uint64_t(broker.connected));
    out.counter("mqtt_connections", "Connections that the MQTT broker accepted.");
    out.sample({}, broker.connections);
    out.counter("mqtt_messages", "Messages for the MQTT broker, by what became of them. State: dropped for a newer one.");
    const std::pair<const char *, const mqtt::PublishCount &> kinds[] = {
        {"state", broker.state}, {"event", broker.event}, {"raw", broker.raw}};
    for (const auto &[kind, count] : kinds) {
        out.sample({{"kind", kind}, {"outcome", "sent"}}, count.sent);
        out.sample({{"kind", kind}, {"outcome", "dropped"}}, count.dropped);
    }
}

} // namespace

std::string openMetrics(const Snapshot &snapshot)
{
    Exposition out;
    writeLink(out, snapshot);
    writeSessions(out, snapshot);
    writeVehicles(out, snapshot);
    writeClients(out, snapshot);
    if (snapshot.broker)
        writeBroker(out, *snapshot.broker);
    out.gauge("resident_bytes", "Memory of this program.");
    out.sample({}, snapshot.residentBytes);
    return std::move(out).end();
}

} // namespace skyseal::engine
