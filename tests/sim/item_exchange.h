// The station's side of the mission protocol, for tests: uploads and downloads a list of items of any type, with repetition.
#pragma once

#include "tests/sim/test_station.h"

namespace skyseal::sim {

/// Uploads as a station does: says the count until something is asked for, then answers what is asked for.
class Uploader
{
public:
    Uploader(TestStation &station, std::vector<mavlink::MissionItemInt> items, std::uint8_t type = 0)
        : m_station(station), m_items(std::move(items)), m_type(type)
    {
        station.onFrame = [this](const mavlink::Frame &frame) { handle(frame); };
    }
    ~Uploader() { m_station.onFrame = {}; }

    /// The result of the vehicle's MISSION_ACK; -1 when none came.
    int run(double limit)
    {
        for (double waited = 0; waited < limit && m_result < 0; waited += 1) {
            if (!m_asked) {
                mavlink::MissionCount count;
                count.target_system = 1;
                count.target_component = 1;
                count.mission_type = m_type;
                count.count = static_cast<std::uint16_t>(m_items.size());
                m_station.send(count);
            } else if (m_sent == m_items.size()) {
                m_station.send(m_items.back()); // the acknowledgement was lost
            }
            m_station.run(1);
        }
        return m_result;
    }

private:
    void handle(const mavlink::Frame &frame)
    {
        if (frame.messageId() == mavlink::MissionRequestInt::kId) {
            const auto request = mavlink::MissionRequestInt::decode(frame.payload());
            if (request.mission_type != m_type)
                return;
            m_asked = true;
            const auto wanted = request.seq;
            m_sent = wanted + std::size_t(1); // before the answer to it comes
            if (wanted < m_items.size())
                m_station.send(m_items[wanted]);
        } else if (frame.messageId() == mavlink::MissionAck::kId) {
            const auto ack = mavlink::MissionAck::decode(frame.payload());
            // An item that came twice is none that the vehicle waits for.
            if (ack.mission_type == m_type && ack.type != mavlink::MAV_MISSION_INVALID_SEQUENCE)
                m_result = ack.type;
        }
    }

    TestStation &m_station;
    std::vector<mavlink::MissionItemInt> m_items;
    std::uint8_t m_type;
    bool m_asked = false;
    std::size_t m_sent = 0; ///< items, the first so many
    int m_result = -1;
};

/// Downloads with repetition; the items in order.
inline std::vector<mavlink::MissionItemInt> download(TestStation &station, std::uint8_t type = 0)
{
    station.forget();
    std::vector<mavlink::MissionItemInt> items;
    for (int tries = 0; tries < 50 && station.count<mavlink::MissionCount>() == 0; ++tries) {
        mavlink::MissionRequestList list;
        list.target_system = 1;
        list.mission_type = type;
        station.send(list);
        station.run(0.2);
    }
    const auto count = station.last<mavlink::MissionCount>().count;
    for (std::uint16_t i = 0; i < count; ++i) {
        for (int tries = 0; tries < 50 && items.size() == i; ++tries) {
            mavlink::MissionRequestInt request;
            request.target_system = 1;
            request.seq = i;
            request.mission_type = type;
            station.send(request);
            station.run(0.04);
            const auto last = station.last<mavlink::MissionItemInt>();
            if (station.count<mavlink::MissionItemInt>() > 0 && last.seq == i)
                items.push_back(last);
        }
    }
    return items;
}

} // namespace skyseal::sim
