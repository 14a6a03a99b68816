// The configuration of the connection to a broker, as one plain value without secrets: those stay in their files.
#pragma once

#include "core/mqtt/broker_url.h"

#include <string>

namespace skyseal::mqtt {

struct PublisherConfig
{
    BrokerUrl broker;
    std::string caFile = {};          ///< PEM; the system's certificates if empty. Only with TLS, as the next two
    std::string certificateFile = {}; ///< PEM, of this client; none if empty
    std::string keyFile = {};         ///< PEM, its private key, without a passphrase
    std::string loginFile = {};       ///< user in the first line, password in the second; none if empty
};

} // namespace skyseal::mqtt
