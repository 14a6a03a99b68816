// The options of the gateway for an MQTT broker.
#pragma once

#include "app/common/options.h"
#include "core/mqtt/publisher_config.h"

#include <optional>

namespace skyseal::app {

struct BrokerPlan
{
    mqtt::PublisherConfig config;
    bool raw = false; ///< the frames, too
};

void declareMqtt(Options &options);
/// nullopt without --mqtt. Records a problem for options that do not fit together.
std::optional<BrokerPlan> readMqtt(Options &options);
/// Says on stderr who can read along, if others than the broker can.
void warnOfOpenBroker(const QString &program, const mqtt::PublisherConfig &config);

} // namespace skyseal::app
