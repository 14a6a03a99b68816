// Example of a client, for recipes_test: sends PING until the vehicle answers. https://mavlink.io/en/services/ping.html
#pragma once

#include "core/vehicle/micro_protocol.h"

namespace skyseal::vehicle {

class PingClient : public MicroProtocol
{
public:
    static constexpr Duration kTimeout = std::chrono::seconds(1);
    static constexpr int kAttempts = 3;

    using MicroProtocol::MicroProtocol;

    bool perform(TimePoint now, RequestId id, const Request &request) override;
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override { return m_deadline; }

private:
    void transmit(TimePoint now);

    RequestId m_request{};
    std::uint32_t m_sequence = 0;
    int m_attempts = 0;
    TimePoint m_sent{};
    TimePoint m_deadline = kNever;
};

} // namespace skyseal::vehicle
