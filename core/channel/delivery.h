// Input and output values of an endpoint: datagrams to send, and opened frames.
#pragma once

#include "core/base/bytes.h"
#include "core/base/path.h"
#include "core/channel/arrival_history.h"
#include "core/channel/freshness.h"
#include "core/channel/session_id.h"
#include "core/channel/stats.h"
#include "core/crypto/suite.h"

namespace skyseal::channel {

/// A datagram to send unchanged. The bytes are valid until the next call of a non-const member of its endpoint.
struct Transmit
{
    Path to;
    ByteView bytes;
};

/// One or several whole MAVLink frames as the peer sealed them; not parsed. The bytes lie in the buffer of the received
/// datagram and are valid as long as that buffer.
struct Delivery
{
    SessionId session{};
    Epoch epoch{};
    crypto::SuiteId suite{};
    RecordPosition position{};
    Freshness freshness{}; ///< frames that are not fresh may not command, nor replace newer values
    ByteView frames;
};

} // namespace skyseal::channel
