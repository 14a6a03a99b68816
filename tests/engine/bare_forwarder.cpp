#include "tests/engine/bare_forwarder.h"

namespace skyseal::test {

double BareForwarder::forward(std::size_t burst)
{
    CpuTimer cpu;
    for (std::size_t sent = 0; sent < kFrames; sent += burst) {
        m_from.send(m_middle.port(), std::span(m_telemetry.frames()).subspan(sent, burst));
        cpu.time([&] {
            while (m_middle.waitReadable(0))
                m_middle.forward(m_to.port(), m_middle.receive());
        });
        while (m_to.receive() > 0) {}
    }
    return cpu.nanosecondsEach(kFrames);
}

} // namespace skyseal::test
