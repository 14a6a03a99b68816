#include "app/cli/mqtt_options.h"

namespace skyseal::app {

void declareMqtt(Options &options)
{
    options.addValue(
        "mqtt", "URL",
        "Publish states and events of the vehicles to an MQTT broker: mqtts://HOST[:PORT][/PREFIX], or mqtt:// without "
        "TLS. Each gateway needs its own PREFIX (default: skyseal). The gateway never subscribes.");
    options.addValue("mqtt-ca", "FILE", "Certificates of the authorities of the broker (PEM); default: those of the system.");
    options.addValue("mqtt-cert", "FILE", "Client certificate of this gateway (PEM).");
    options.addValue("mqtt-key", "FILE", "Private key of --mqtt-cert (PEM, no passphrase), not readable by other users.");
    options.addValue("mqtt-login", "FILE",
                     "File with the user name in the first line and the password in the second, not readable by other users.");
    options.addFlag("mqtt-raw", "Also publish the MAVLink frames of the vehicles.");
}

std::optional<BrokerPlan> readMqtt(Options &options)
{
    if (!options.has("mqtt")) {
        for (const char *name : {"mqtt-ca", "mqtt-cert", "mqtt-key", "mqtt-login", "mqtt-raw"}) {
            if (options.has(name))
                options.fail(std::string("--") + name + " requires --mqtt");
        }
        return std::nullopt;
    }
    auto url = mqtt::BrokerUrl::parse(options.text("mqtt"));
    if (!url) {
        options.fail("--mqtt: " + url.error().text());
        return std::nullopt;
    }
    BrokerPlan out{{.broker = std::move(*url)}, options.has("mqtt-raw")};
    const auto file = [&options](const char *name) { return options.has(name) ? options.required(name) : std::string(); };
    out.config.caFile = file("mqtt-ca");
    out.config.certificateFile = file("mqtt-cert");
    out.config.keyFile = file("mqtt-key");
    out.config.loginFile = file("mqtt-login");
    for (const char *name : {"mqtt-ca", "mqtt-cert", "mqtt-key"}) {
        if (options.has(name) && !out.config.broker.tls)
            options.fail(std::string("--") + name + ": mqtt:// has no TLS; use mqtts://");
    }
    if (out.config.certificateFile.empty() != out.config.keyFile.empty())
        options.fail("--mqtt-cert and --mqtt-key require each other");
    return out;
}

void warnOfOpenBroker(const QString &program, const mqtt::PublisherConfig &config)
{
    if (config.broker.tls || config.broker.isLoopback())
        return;
    complain(program,
             config.broker.toText() + ": without TLS: anyone on the path can read and forge the states of the vehicles"
                 + (config.loginFile.empty() ? "" : ", and read the password"),
             mavlink::MAV_SEVERITY_WARNING);
}

} // namespace skyseal::app
