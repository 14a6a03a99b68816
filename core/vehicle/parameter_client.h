// Client of the parameter protocol: reads the whole list, requests lost parameters again by index, and checks each write by
// the value that the vehicle reports.
// https://mavlink.io/en/services/parameter.html
#pragma once

#include "core/vehicle/micro_protocol.h"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

class ParameterClient : public MicroProtocol
{
public:
    static constexpr Duration kListTimeout = std::chrono::seconds(1); ///< without a parameter, then gaps are requested
    static constexpr Duration kWriteTimeout = std::chrono::seconds(1);
    static constexpr int kRounds = 10; ///< without a new parameter, then the read fails
    static constexpr int kWriteAttempts = 5;
    static constexpr std::size_t kBatch = 10; ///< gaps requested at a time, so that a slow radio keeps up
    /// Names kept in all, and beyond the number that the vehicle announces: a write can make further parameters visible.
    static constexpr std::size_t kMostNames = 8192;
    static constexpr std::size_t kNamesBeyondCount = 64;
    /// Changes that answer no write are collected for so long before parameters() shows them.
    static constexpr Duration kCollectFor = std::chrono::milliseconds(500);

    using MicroProtocol::MicroProtocol;

    /// ReadParameters and WriteParameter. Writes are carried out one after the other.
    bool perform(TimePoint now, RequestId id, const Request &request) override;
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override;

    /// Sorted by name; null before the first parameter. A new object after a change, at most one in kCollectFor, besides the
    /// results of writes and complete reads.
    std::shared_ptr<const std::vector<Parameter>> parameters() const;
    std::uint32_t expected() const { return m_expected; }

private:
    struct Write
    {
        RequestId id{};
        WriteParameter request;
        int attempts = 0;
        TimePoint deadline = kNever;
        std::optional<Parameter> reported{}; ///< the vehicle's parameter, while its value differs from the request
    };

    /// Integers travel as their bytes (PX4) or as floats (ArduPilot).
    bool isBytewise() const;
    double decode(float raw, std::uint8_t type) const;
    float encode(double value, std::uint8_t type) const;
    bool isReading() const { return m_listDeadline != kNever; }
    void read(TimePoint now, RequestId id);
    void write(TimePoint now, RequestId id, const WriteParameter &request);
    void handleValue(TimePoint now, const mavlink::ParamValue &value);
    void noteIndex(TimePoint now, std::uint16_t index, std::uint16_t count);
    bool store(Parameter parameter);
    bool mayAdd() const;
    void publish(TimePoint now);
    void requestList(TimePoint now);
    void requestGaps(TimePoint now);
    void handleListDeadline(TimePoint now);
    void handleWriteDeadline(TimePoint now);
    void sendWrite(TimePoint now);
    bool checkWrite(TimePoint now, const Parameter &parameter);
    void finishWrite(TimePoint now, ParameterResult result);

    std::map<std::string, Parameter, std::less<>> m_values;
    RequestId m_read{};
    std::vector<bool> m_have; ///< by index
    std::uint32_t m_expected = 0;
    std::size_t m_received = 0;
    TimePoint m_listDeadline = kNever;
    int m_roundsWithoutNew = 0;
    std::deque<Write> m_writes;                                     ///< the first one is in progress
    mutable std::shared_ptr<const std::vector<Parameter>> m_shared; ///< built on demand
    TimePoint m_published = TimePoint::min();                       ///< time of the latest change of the shared list
    TimePoint m_publishDue = kNever;                                ///< there are collected changes
};

} // namespace skyseal::vehicle
