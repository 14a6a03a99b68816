// A client of a MAVLink micro-protocol (files, logs) between its user and a vehicle, on a simulated clock. What the vehicle
// sends waits in a queue: steps of the input let it arrive, lose, repeat, reorder, change or invent it. Whatever they are, a
// request ends with one result, in bounded time and memory.
#pragma once

#include "core/base/byte_reader.h"
#include "core/mavlink/frame_reader.h"
#include "core/mavlink/frame_writer.h"
#include "core/vehicle/micro_protocol.h"
#include "tests/fuzz/oracle.h"

#include <deque>
#include <set>
#include <utility>
#include <vector>

namespace skyseal::test {

/// The vehicle: takes what the client sends, and gives what is to be sent to it, each as one frame.
class BenchVehicle
{
public:
    virtual ~BenchVehicle() = default;
    int ignored = 0; ///< so many requests are lost

    virtual void handle(const vehicle::OutMessage &message) = 0;
    /// The next message of an answer under way, such as a burst; empty if there is none.
    virtual Bytes next() = 0;

protected:
    template<typename Message> static Bytes frame(const Message &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        mavlink::FrameWriter writer(1, 1);
        const ByteView out = writer.write(message, buffer);
        return Bytes(out.begin(), out.end());
    }
};

/// `Result`: the event by which the client reports the end of a request.
template<typename Client, typename Result> class ClientBench
{
public:
    explicit ClientBench(BenchVehicle &vehicle) : m_vehicle(vehicle), m_allocated(allocatedBytes()) {}

    /// Starts a request and returns its number, which its result carries.
    vehicle::RequestId perform(const vehicle::Request &request)
    {
        const auto id = vehicle::RequestId{++m_requests};
        m_open.insert(id);
        m_client.perform(m_now, id, request);
        drain();
        return id;
    }
    bool isIdle() const { return !m_client.progress(); }
    std::vector<Result> takeResults() { return std::exchange(m_results, {}); }
    /// The vehicle has sent what is not so.
    bool isHostile() const { return m_isHostile; }

    /// Runs the steps of the input: `own(operation, argument)` those that belong to the client alone, 8 and more. `judge()`
    /// follows each. At last the vehicle falls silent, or answers everything at once: either way each request ends.
    template<typename Own, typename Judge> void run(ByteReader &in, Own &&own, Judge &&judge)
    {
        for (int steps = 0; steps < 400 && in.ok() && !in.atEnd(); ++steps) {
            const std::uint8_t operation = in.u8() % kOperations, argument = in.u8();
            if (operation < kFirstOwn)
                step(operation, argument, in);
            else
                own(operation, argument);
            judge();
            checkMemory();
        }
        finish();
        judge();
    }
    /// A hostile vehicle: a message of its own.
    template<typename Message> void invent(const Message &message)
    {
        m_isHostile = true;
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        mavlink::FrameWriter writer(1, 1);
        const ByteView bytes = writer.write(message, buffer);
        take(Bytes(bytes.begin(), bytes.end()));
    }

private:
    static constexpr std::uint8_t kFirstOwn = 8, kOperations = 12;
    static constexpr int kMostRounds = 20'000;
    static constexpr std::size_t kMostHistory = 32;
    static constexpr Duration kLongest = std::chrono::minutes(10);

    void step(std::uint8_t operation, std::uint8_t argument, ByteReader &in)
    {
        switch (operation) {
        case 0: return arrive(argument);
        case 1: return pass(argument * std::chrono::milliseconds(10));
        case 2: return pass(argument * std::chrono::milliseconds(100));
        case 3: return lose(argument);
        case 4: return repeat(argument);
        case 5: return delay(argument % 16);
        case 6: return change(argument, in.u8());
        default: return control(argument);
        }
    }
    void control(std::uint8_t argument)
    {
        if (argument & 1)
            cancel();
        if (argument & 2)
            m_vehicle.ignored = argument >> 4;
        if (argument & 4)
            m_answersAtLast = argument & 8;
    }

    void cancel()
    {
        if (const auto progress = m_client.progress())
            m_client.perform(m_now, vehicle::RequestId{++m_requests}, vehicle::CancelTransfer{progress->id});
        drain();
    }

    void pass(Duration span)
    {
        const TimePoint end = m_now + span;
        for (int rounds = 0; m_client.nextDeadline() <= end; ++rounds) {
            if (rounds > kMostRounds)
                violated("no deadline comes again and again");
            m_now = std::max(m_now, m_client.nextDeadline());
            m_client.handleDeadline(m_now);
            drain();
        }
        m_now = end;
    }

    /// Frames on their way arrive, `count` of them.
    void arrive(std::size_t count)
    {
        for (; count > 0; --count) {
            fill();
            if (m_queue.empty())
                return;
            const Bytes bytes = std::move(m_queue.front());
            m_queue.pop_front();
            take(bytes);
        }
    }
    void lose(std::size_t count)
    {
        for (; count > 0; --count) {
            fill();
            if (!m_queue.empty())
                m_queue.pop_front();
        }
    }
    void repeat(std::size_t choice)
    {
        if (!m_history.empty())
            take(Bytes(m_history[choice % m_history.size()]));
    }
    /// The first frame on its way goes behind others.
    void delay(std::size_t places)
    {
        for (std::size_t i = 0; i <= places; ++i)
            fill();
        if (m_queue.empty())
            return;
        Bytes first = std::move(m_queue.front());
        m_queue.pop_front();
        const std::size_t at = std::min(places, m_queue.size());
        m_queue.insert(m_queue.begin() + static_cast<std::ptrdiff_t>(at), std::move(first));
    }
    /// A hostile vehicle: the next message with some bytes of its payload changed.
    void change(std::uint8_t at, std::uint8_t by)
    {
        fill();
        if (m_queue.empty())
            return;
        m_isHostile = true;
        Bytes bytes = std::move(m_queue.front());
        m_queue.pop_front();
        const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
        Bytes payload(frame->payload().begin(), frame->payload().end());
        payload[at % payload.size()] ^= static_cast<std::uint8_t>(1 + by % 255);
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        mavlink::FrameWriter writer(1, 1);
        const ByteView changed = writer.write(frame->messageId(), frame->info().crcExtra, frame->info().minLength, payload,
                                              buffer);
        take(Bytes(changed.begin(), changed.end()));
    }

    void finish()
    {
        m_queue.clear();
        const TimePoint end = m_now + kLongest;
        for (int rounds = 0; !isIdle(); ++rounds) {
            if (m_now > end || rounds > kMostRounds)
                violated("every request ends");
            if (m_answersAtLast)
                arrive(64);
            if (!isIdle())
                pass(std::max(m_client.nextDeadline() - m_now, Duration(0)));
        }
        if (!m_open.empty())
            violated("every request ends");
    }

    void checkMemory() const
    {
        if (allocatedBytes() > m_allocated + (24u << 20))
            violated("nothing grows");
    }

    void fill()
    {
        if (m_queue.empty() || m_queue.size() < 4) {
            if (Bytes next = m_vehicle.next(); !next.empty())
                m_queue.push_back(std::move(next));
        }
    }
    void take(const Bytes &bytes)
    {
        m_history.push_back(bytes);
        if (m_history.size() > kMostHistory)
            m_history.pop_front();
        if (const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin()))
            m_client.handleFrame(m_now, *frame);
        drain();
    }
    void drain()
    {
        while (const vehicle::OutMessage *message = m_context.outbox.take())
            if (m_vehicle.ignored > 0)
                --m_vehicle.ignored;
            else
                m_vehicle.handle(*message);
        for (vehicle::Event &event : std::exchange(m_context.events, {})) {
            Result *result = std::get_if<Result>(&event);
            if (!result || m_open.erase(result->id) != 1)
                violated("one result for each request");
            m_results.push_back(std::move(*result));
        }
        if (isIdle() != (m_client.nextDeadline() == kNever))
            violated("every request ends");
    }

    BenchVehicle &m_vehicle;
    vehicle::VehicleContext m_context;
    Client m_client{m_context};
    TimePoint m_now{std::chrono::hours(1)};
    std::deque<Bytes> m_queue, m_history;
    std::uint32_t m_requests = 0;
    std::set<vehicle::RequestId> m_open; ///< without a result
    std::vector<Result> m_results;
    bool m_isHostile = false;
    bool m_answersAtLast = true;
    std::size_t m_allocated;
};

} // namespace skyseal::test
