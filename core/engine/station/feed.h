// A receiver of the vehicles' frames that is no MAVLink program, and therefore no client of the gateway: a broker.
#pragma once

#include "core/base/bytes.h"
#include "core/mqtt/publisher_status.h"

namespace skyseal::engine {

class Feed
{
public:
    virtual ~Feed() = default;

    /// A frame of a vehicle that the station accepted, byte for byte. Called on the I/O thread for each one: must not block.
    virtual void takeFrame(ByteView frame) = 0;
    /// For snapshots; called on the I/O thread.
    virtual mqtt::PublisherStatus status() const = 0;
};

} // namespace skyseal::engine
