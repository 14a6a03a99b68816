// Telemetry of one vehicle as whole frames: the mix of messages that a copter streams, about 37 bytes a frame, filled with
// seeded noise so that no trailing zeros are cut.
#pragma once

#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

#include <random>
#include <vector>

namespace skyseal::test {

class SampleTraffic
{
public:
    /// A multiple of 256 frames can be sent again and again without a gap in their sequence numbers.
    explicit SampleTraffic(std::size_t count, std::uint8_t systemId = 1) : m_writer(systemId, 1)
    {
        using namespace mavlink;
        while (m_frames.size() < count) {
            switch (m_frames.size() % 8) {
            case 0: add(Heartbeat{.type = MAV_TYPE_QUADROTOR, .autopilot = MAV_AUTOPILOT_ARDUPILOTMEGA}); break;
            case 2: addNoise<GlobalPositionInt>(); break;
            case 3: addNoise<VfrHud>(); break;
            case 4: addNoise<SystemTime>(); break;
            case 5: addNoise<SysStatus>(); break;
            case 6: addNoise<GpsRawInt>(); break;
            default: addNoise<Attitude>(); break;
            }
        }
        for (const Bytes &frame : m_frames)
            m_views.emplace_back(frame);
    }

    const std::vector<ByteView> &frames() const { return m_views; }
    double meanLength() const
    {
        double sum = 0;
        for (const ByteView frame : m_views)
            sum += static_cast<double>(frame.size());
        return sum / static_cast<double>(m_views.size());
    }

private:
    template<typename Message> void add(const Message &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = m_writer.write(message, buffer);
        m_frames.emplace_back(frame.begin(), frame.end());
    }
    template<typename Message> void addNoise()
    {
        std::array<std::uint8_t, Message::kMaxLength> payload;
        for (std::uint8_t &byte : payload)
            byte = static_cast<std::uint8_t>(m_random() | 1);
        add(Message::decode(payload));
    }

    std::minstd_rand m_random{1};
    mavlink::FrameWriter m_writer;
    std::vector<Bytes> m_frames;
    std::vector<ByteView> m_views;
};

} // namespace skyseal::test
