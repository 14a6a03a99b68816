// The address of an MQTT broker and the prefix of the topics: mqtts://HOST[:PORT][/PREFIX], or mqtt:// without TLS.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace skyseal::mqtt {

struct BrokerUrl
{
    /// Ports that IANA registered for MQTT.
    static constexpr std::uint16_t kPort = 1883, kTlsPort = 8883;
    static constexpr std::size_t kLongestPrefix = 128;

    /// The error names the invalid part. User names and passwords are refused: every user of the machine can read a command
    /// line.
    static Result<BrokerUrl, InputError> parse(std::string_view text);

    /// As parse() takes it, with port and prefix.
    std::string toText() const;
    /// Whether the broker is on this machine by its address.
    bool isLoopback() const;

    bool tls = true;
    std::string host; ///< a name or an address; IPv6 without brackets
    std::uint16_t port = kTlsPort;
    std::string prefix = "skyseal"; ///< of every topic, without slashes at its ends
};

} // namespace skyseal::mqtt
