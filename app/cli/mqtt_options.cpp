#include "app/cli/mqtt_options.h"

namespace skyseal::app {

void declareMqtt(Options &options)
{
    options.addValue(
        "mqtt", "URL",
        "Publish states and events of the vehicles to an MQTT broker: mqtts://HOST[:PORT][/PREFIX], or mqtt:// without "
        "TLS. Each gateway needs a PREFIX of its own (default skyseal). No command is taken from there.");
    options.addValue("mqtt-ca", "FILE",
                     "Certificates by which the broker has to prove its name (PEM); without it the system's.");
    options.addValue("mqtt-cert", "FILE", "Certificate of this gateway for the broker (PEM).");
    options.addValue("mqtt-key", "FILE", "Private key of --mqtt-cert (PEM, no passphrase), not readable by other users.");
    options.addValue("mqtt-login", "FILE",
                     "File with the user in its first line and the password in its second, not readable by other users.");
    options.addFlag("mqtt-raw", "Also publish the MAVLink frames of the vehicles.");
}

std::optional<BrokerPlan> readMqtt(Options &options)
{
    if (!options.has("mqtt")) {
        for (const char *name : {"mqtt-ca", "mqtt-cert", "mqtt-key", "mqtt-login", "mqtt-raw"}) {
            if (options.has(name))
                options.fail(std::string("--") + name + ": --mqtt names no broker");
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
        options.fail("--mqtt-cert and --mqtt-key belong together");
    return out;
}

void warnOfOpenBroker(const QString &program, const mqtt::PublisherConfig &config)
{
    if (config.broker.tls || config.broker.isLoopback())
        return;
    complain(program,
             config.broker.toText() + ": without TLS: anyone on the way can see and forge the vehicles' states"
                 + (config.loginFile.empty() ? "" : ", and read the password"));
}

} // namespace skyseal::app
