// Receives the frames of the vehicles for a consumer that is not a MAVLink program, and therefore not a client of the gateway:
// a broker.
#pragma once

#include "core/base/bytes.h"
#include "core/mqtt/publisher_status.h"

namespace skyseal::engine {

class Feed
{
public:
    virtual ~Feed() = default;

    /// Takes an accepted frame of a vehicle, byte for byte. Called on the I/O thread for each frame: must not block.
    virtual void takeFrame(ByteView frame) = 0;
    /// For snapshots; called on the I/O thread.
    virtual mqtt::PublisherStatus status() const = 0;
};

} // namespace skyseal::engine
