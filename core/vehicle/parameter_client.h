// MAVLink's parameter protocol: reads the whole list, asks again by index for what was lost, and writes with read-back.
// https://mavlink.io/en/services/parameter.html
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/message_queue.h"
#include "core/vehicle/parameter.h"
#include "core/vehicle/transfer_result.h"
#include "core/vehicle/vehicle_config.h"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

/// A PARAM_VALUE as it came in. The name is read up to its first NUL.
struct ParameterValue
{
    std::string_view name;
    float value = 0;
    std::uint8_t type = mavlink::MAV_PARAM_TYPE_REAL32; ///< MAV_PARAM_TYPE
    std::uint16_t count = 0;                            ///< of all parameters
    std::uint16_t index = 0;                            ///< 65535 where it is an answer to a name
};

class ParameterClient
{
public:
    static constexpr Duration kListTimeout = std::chrono::seconds(1); ///< of silence, then gaps are asked for
    static constexpr Duration kWriteTimeout = std::chrono::seconds(1);
    static constexpr int kRounds = 10; ///< without a single new parameter, then the reading is given up
    static constexpr int kWriteAttempts = 5;
    static constexpr std::size_t kBatch = 10; ///< gaps asked for at a time, so that a slow radio keeps up

    explicit ParameterClient(const Addressing &addressing) : m_addressing(addressing) {}

    /// Integers as the bytes of an integer (PX4), or as floats (ArduPilot).
    void setBytewise(bool bytewise) { m_bytewise = bytewise; }

    void readAll(TimePoint now, MessageQueue &outbox);
    void write(TimePoint now, std::string name, double value, MessageQueue &outbox);
    void handleValue(TimePoint now, const ParameterValue &value, MessageQueue &outbox);
    void handleDeadline(TimePoint now, MessageQueue &outbox);
    TimePoint nextDeadline() const;

    /// Sorted by name; null before the first. A new object after every change.
    std::shared_ptr<const std::vector<Parameter>> parameters() const;
    std::uint32_t expected() const { return m_expected; }
    std::size_t received() const { return m_received; }
    bool isReading() const { return m_listDeadline != kNever; }

    /// How writes ended; a reading that was given up shows as one with an empty name.
    std::optional<ParameterResult> poll();

private:
    struct Write
    {
        std::string name;
        double value = 0;
        int attempts = 0;
        TimePoint deadline = kNever;
        std::optional<Parameter> seen; ///< what the vehicle said it has, when that is something else
    };

    double decode(float raw, std::uint8_t type) const;
    float encode(double value, std::uint8_t type) const;
    void requestList(TimePoint now, MessageQueue &outbox);
    void requestGaps(TimePoint now, MessageQueue &outbox);
    void sendWrite(TimePoint now, MessageQueue &outbox);
    void checkWrite(TimePoint now, const Parameter &parameter, MessageQueue &outbox);
    void finishWrite(TimePoint now, ParameterResult result, MessageQueue &outbox);

    Addressing m_addressing;
    bool m_bytewise = false;
    std::map<std::string, Parameter, std::less<>> m_values;
    std::vector<bool> m_have; ///< by index
    std::uint32_t m_expected = 0;
    std::size_t m_received = 0;
    TimePoint m_listDeadline = kNever;
    int m_fruitless = 0;
    std::deque<Write> m_writes; ///< the first one is under way
    std::deque<ParameterResult> m_results;
    mutable std::shared_ptr<const std::vector<Parameter>> m_shared; ///< built when asked for
};

} // namespace skyseal::vehicle
