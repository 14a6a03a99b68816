// The client of the log protocol before a vehicle whose messages are lost, repeated, reordered, changed and invented. Whatever
// comes, each request ends with one result in bounded time and memory; and as long as the vehicle says what is so, the list and
// the logs are those of the vehicle.
#include "core/vehicle/log_client.h"
#include "core/vehicle/onboard_log.h"
#include "tests/fuzz/client_bench.h"

#include <algorithm>
#include <map>

using namespace skyseal;
using namespace skyseal::test;

namespace {

class LogVehicle final : public BenchVehicle
{
public:
    /// `traits`, bit 0: logs are listed larger than they are; 1: it has none; 2: it erases nothing; 3: the first one is large.
    explicit LogVehicle(std::uint8_t traits) : m_traits(traits)
    {
        if (traits & 2)
            return;
        for (const auto &[id, size] : {std::pair(1, traits & 8 ? 100'000 : 900), {2, 0}, {3, 91}, {7, 4000}}) {
            Bytes &log = logs[static_cast<std::uint16_t>(id)];
            for (int i = 0; i < size; ++i)
                log.push_back(static_cast<std::uint8_t>(i * 7 + i / 90 + id));
        }
    }

    std::map<std::uint16_t, Bytes> logs;

    std::uint32_t listedSize(const Bytes &log) const
    {
        return static_cast<std::uint32_t>(log.size()) + (m_traits & 1 ? 500 : 0);
    }

    void handle(const vehicle::OutMessage &message) override
    {
        if (message.id == mavlink::LogRequestList::kId) {
            list(mavlink::LogRequestList::decode(message.view()));
        } else if (message.id == mavlink::LogRequestData::kId) {
            if (m_runs.size() < kMostRuns)
                m_runs.push_back(mavlink::LogRequestData::decode(message.view()));
        } else if (message.id == mavlink::LogRequestEnd::kId) {
            m_runs.clear();
        } else if (message.id == mavlink::LogErase::kId && !(m_traits & 4)) {
            logs.clear();
        }
    }
    Bytes next() override
    {
        if (!m_entries.empty()) {
            Bytes out = std::move(m_entries.front());
            m_entries.pop_front();
            return out;
        }
        while (!m_runs.empty()) {
            mavlink::LogRequestData &run = m_runs.front();
            const auto log = logs.find(run.id);
            if (log == logs.end()) {
                m_runs.pop_front();
                continue;
            }
            const std::size_t rest = run.ofs < log->second.size() ? log->second.size() - run.ofs : 0;
            mavlink::LogData data;
            data.id = run.id;
            data.ofs = run.ofs;
            data.count = static_cast<std::uint8_t>(std::min<std::size_t>({90, run.count, rest}));
            std::copy_n(log->second.end() - static_cast<std::ptrdiff_t>(rest), data.count, data.data.begin());
            run.ofs += 90;
            run.count -= std::min<std::uint32_t>(run.count, 90);
            if (run.count == 0 || data.count < 90)
                m_runs.pop_front();
            return frame(data);
        }
        return {};
    }

private:
    static constexpr std::size_t kMostRuns = 64;

    void list(const mavlink::LogRequestList &request)
    {
        mavlink::LogEntry entry;
        entry.num_logs = static_cast<std::uint16_t>(logs.size());
        entry.last_log_num = logs.empty() ? std::uint16_t(0) : logs.rbegin()->first;
        m_entries.clear();
        if (logs.empty())
            m_entries.push_back(frame(entry));
        for (const auto &[id, log] : logs) {
            entry.id = id;
            entry.size = listedSize(log);
            entry.time_utc = 1000u + id;
            if (id >= request.start && id <= request.end)
                m_entries.push_back(frame(entry));
        }
    }

    const std::uint8_t m_traits;
    std::deque<Bytes> m_entries;
    std::deque<mavlink::LogRequestData> m_runs;
};

class LogTransfers
{
public:
    explicit LogTransfers(std::uint8_t traits) : m_vehicle(traits), m_bench(m_vehicle) {}

    void run(ByteReader &in)
    {
        m_bench.run(
            in, [&](std::uint8_t operation, std::uint8_t argument) { step(operation, argument, in); }, [this] { judge(); });
    }

private:
    void step(std::uint8_t operation, std::uint8_t argument, ByteReader &in)
    {
        switch (operation) {
        case 8:
        case 9: return perform(argument);
        case 10: return inventEntry(argument, in);
        default: return inventData(argument, in);
        }
    }

    void perform(std::uint8_t choice)
    {
        switch (choice & 3) {
        case 0: m_bench.perform(vehicle::ListLogs{}); return;
        case 1: m_bench.perform(vehicle::EraseLogs{}); return;
        default: m_bench.perform(vehicle::ReadLog{static_cast<std::uint16_t>(choice >> 2 & 7)}); return;
        }
    }

    /// Messages of which the input tells every field.
    void inventEntry(std::uint8_t choice, ByteReader &in)
    {
        mavlink::LogEntry entry;
        entry.id = choice & 1 ? in.u16() : in.u8();
        entry.num_logs = choice & 2 ? in.u16() : in.u8();
        entry.size = choice & 4 ? in.u32() : in.u16();
        m_bench.invent(entry);
    }
    void inventData(std::uint8_t choice, ByteReader &in)
    {
        mavlink::LogData data;
        data.id = in.u8();
        data.ofs = choice & 4 ? in.u32() : in.u16() * 90u;
        data.count = in.u8();
        m_bench.invent(data);
    }

    void judge()
    {
        for (const vehicle::LogResult &result : m_bench.takeResults()) {
            if (!result.ok || m_bench.isHostile())
                continue;
            const auto log = m_vehicle.logs.find(result.log);
            switch (result.action) {
            case vehicle::LogAction::List:
                if (!result.entries || !isList(*result.entries))
                    violated("the list is that of the vehicle");
                break;
            case vehicle::LogAction::Read:
                if (log == m_vehicle.logs.end() || !result.content || *result.content != log->second)
                    violated("what was read is what the vehicle has");
                break;
            case vehicle::LogAction::Erase:
                if (!m_vehicle.logs.empty())
                    violated("what was erased is gone");
                break;
            }
        }
    }
    bool isList(const std::vector<vehicle::OnboardLog> &entries) const
    {
        return std::ranges::equal(entries, m_vehicle.logs, [this](const vehicle::OnboardLog &entry, const auto &log) {
            return entry.id == log.first && entry.size == m_vehicle.listedSize(log.second);
        });
    }

    LogVehicle m_vehicle;
    ClientBench<vehicle::LogClient, vehicle::LogResult> m_bench;
};

} // namespace

/// The traits of the vehicle, then steps.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ByteReader in(ByteView(data, size));
    LogTransfers transfers(in.u8());
    transfers.run(in);
    return 0;
}
