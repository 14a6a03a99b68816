// Interface to the publisher of messages to a broker. Thread-safe, and no call blocks on the network. Topics are relative to
// the prefix of the broker's URL; topics.h makes them.
#pragma once

#include "core/base/bytes.h"
#include "core/mqtt/publisher_status.h"

#include <string>

namespace skyseal::mqtt {

class MessageSink
{
public:
    virtual ~MessageSink() = default;

    /// The present state of something; a newer one replaces it, also while it waits. Retained by the broker, QoS 0.
    virtual void putState(std::string topic, std::string payload) = 0;
    /// Something that happened once. QoS 1: repeated until the broker has confirmed it.
    virtual void putEvent(std::string topic, std::string payload) = 0;
    /// A whole MAVLink frame of a vehicle. QoS 0; frames of one vehicle are coalesced into messages.
    virtual void putRaw(std::uint8_t systemId, ByteView frame) = 0;

    virtual PublisherStatus status() const = 0;
};

} // namespace skyseal::mqtt
