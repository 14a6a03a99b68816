#pragma once

#include "tests/engine/engine_rig.h"

namespace skyseal::test {

/// The minimum of any forwarder: wait, recvmmsg, sendmmsg.
class BareForwarder
{
public:
    double forward(std::size_t burst);

private:
    BareSocket m_from, m_middle, m_to;
    SampleTraffic m_telemetry{kFrames};
};

} // namespace skyseal::test
