// The client of MAVLink FTP before a vehicle whose messages are lost, repeated, reordered, changed and invented. Whatever
// comes, each request ends with one result in bounded time and memory; and as long as the vehicle says what is so, what was
// read is what the vehicle has, and what was written is there.
#include "core/vehicle/ftp_client.h"
#include "core/vehicle/remote_file.h"
#include "tests/fuzz/client_bench.h"

#include <algorithm>
#include <map>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// The payload of FILE_TRANSFER_PROTOCOL, written and read independently of the client.
struct Payload
{
    static constexpr std::size_t kMostData = 239;

    std::uint16_t sequence = 0;
    std::uint8_t session = 0, opcode = 0, size = 0, requested = 0;
    bool burstComplete = false;
    std::uint32_t offset = 0;
    std::array<std::uint8_t, kMostData> data{};

    static Payload read(const std::array<std::uint8_t, 251> &bytes)
    {
        ByteReader in(bytes);
        Payload out;
        out.sequence = in.u16();
        out.session = in.u8();
        out.opcode = in.u8();
        out.size = in.u8();
        out.requested = in.u8();
        out.burstComplete = in.u8() != 0;
        in.u8(); // padding
        out.offset = in.u32();
        std::ranges::copy(in.rest(), out.data.begin());
        return out;
    }
    mavlink::FileTransferProtocol message() const
    {
        mavlink::FileTransferProtocol out;
        out.target_system = 255;
        out.target_component = 190;
        const std::uint8_t head[] = {static_cast<std::uint8_t>(sequence),
                                     static_cast<std::uint8_t>(sequence >> 8),
                                     session,
                                     opcode,
                                     size,
                                     requested,
                                     burstComplete,
                                     0,
                                     static_cast<std::uint8_t>(offset),
                                     static_cast<std::uint8_t>(offset >> 8),
                                     static_cast<std::uint8_t>(offset >> 16),
                                     static_cast<std::uint8_t>(offset >> 24)};
        std::ranges::copy(head, out.payload.begin());
        std::ranges::copy(data, out.payload.begin() + std::size(head));
        return out;
    }
    ByteView view() const { return ByteView(data).first(std::min<std::size_t>(size, kMostData)); }
    void set(ByteView bytes)
    {
        size = static_cast<std::uint8_t>(std::min(bytes.size(), kMostData));
        std::copy_n(bytes.begin(), size, data.begin());
    }
    void setNumber(std::uint32_t number)
    {
        for (std::size_t i = 0; i < 4; ++i)
            data[i] = static_cast<std::uint8_t>(number >> 8 * i);
        size = 4;
    }
};

enum Opcode : std::uint8_t {
    Terminate = 1,
    Reset = 2,
    List = 3,
    Open = 4,
    Read = 5,
    Create = 6,
    Write = 7,
    Remove = 8,
    Checksum = 14,
    Burst = 15,
    Ack = 128,
    Nak = 129
};
enum Error : std::uint8_t { NoError = 0, NoSessions = 5, EndOfFile = 6, UnknownCommand = 7, NotFound = 10 };

class FileVehicle final : public BenchVehicle
{
public:
    /// `traits`, bit 0: no bursts; 1: no checksums; 2: files are announced too large; 3: each file that is opened gets another
    /// session; 4: bursts of three messages; 5: the first file that is opened finds no session.
    explicit FileVehicle(std::uint8_t traits) : m_traits(traits), m_isBusy(traits & 32)
    {
        for (const auto &[path, size] : {std::pair("a", 700), {"b", 5000}, {"c", 0}, {"d", 239}, {"@e", 1000}, {"f", 478}}) {
            for (int i = 0; i < size; ++i)
                files[path].push_back(static_cast<std::uint8_t>(i * 7 + i / 239 + path[0]));
            files[path]; // also an empty one
        }
    }

    std::map<std::string, Bytes> files;

    void handle(const vehicle::OutMessage &message) override
    {
        if (message.id != mavlink::FileTransferProtocol::kId)
            return;
        const Payload request = Payload::read(mavlink::FileTransferProtocol::decode(message.view()).payload);
        if (m_last && m_last->sequence == static_cast<std::uint16_t>(request.sequence + 1)
            && m_last->requested == request.opcode)
            return m_answers.push_back(frame(m_last->message()));
        Payload answer;
        answer.sequence = static_cast<std::uint16_t>(request.sequence + 1);
        answer.session = request.session;
        answer.requested = request.opcode;
        answer.opcode = Ack;
        answer.offset = request.offset;
        if (request.opcode == Burst && !(m_traits & 1)) {
            m_burst = answer;
            m_left = m_traits & 16 ? 3 : 100;
            return;
        }
        if (const Error error = serve(request, answer)) {
            answer.opcode = Nak;
            answer.data[0] = error;
            answer.size = 1;
        }
        m_last = answer;
        m_answers.push_back(frame(answer.message()));
    }
    Bytes next() override
    {
        if (!m_answers.empty()) {
            Bytes out = std::move(m_answers.front());
            m_answers.pop_front();
            return out;
        }
        return m_left > 0 ? nextOfBurst() : Bytes();
    }

private:
    Bytes nextOfBurst()
    {
        const Bytes &content = files[m_path];
        --m_left;
        if (m_burst.offset >= content.size()) {
            m_left = 0;
            Payload end = m_burst;
            end.opcode = Nak;
            end.data[0] = EndOfFile;
            end.size = 1;
            return frame(end.message());
        }
        m_burst.set(ByteView(content).subspan(m_burst.offset));
        m_burst.burstComplete = m_left == 0;
        Bytes out = frame(m_burst.message());
        m_burst.offset += m_burst.size;
        ++m_burst.sequence;
        return out;
    }

    void open(const std::string &path, Payload &answer)
    {
        m_path = path;
        m_left = 0;
        m_session = static_cast<std::uint8_t>(m_traits & 8 ? m_session + 1 : 7);
        answer.session = m_session;
    }
    Error serve(const Payload &request, Payload &answer)
    {
        const std::string path(asText(request.view()));
        switch (request.opcode) {
        case List: return list(request.offset, answer);
        case Open:
            if (std::exchange(m_isBusy, false))
                return NoSessions;
            if (!files.contains(path))
                return NotFound;
            open(path, answer);
            answer.setNumber(static_cast<std::uint32_t>(files[path].size()) + (m_traits & 4 ? 1000 : 0));
            return NoError;
        case Create:
            files[path].clear();
            open(path, answer);
            return NoError;
        case Read: {
            const Bytes &content = files[m_path];
            if (request.offset >= content.size())
                return EndOfFile;
            answer.set(ByteView(content).subspan(request.offset));
            return NoError;
        }
        case Write: {
            Bytes &content = files[m_path];
            content.resize(std::max<std::size_t>(content.size(), request.offset + request.view().size()));
            std::ranges::copy(request.view(), content.begin() + request.offset);
            return NoError;
        }
        case Remove: return files.erase(path) == 1 ? NoError : NotFound;
        case Checksum:
            if (m_traits & 2)
                return UnknownCommand;
            answer.setNumber(checksum(files[path]));
            return NoError;
        case Terminate:
        case Reset: m_left = 0; return NoError;
        default: return UnknownCommand;
        }
    }
    Error list(std::uint32_t offset, Payload &answer) const
    {
        std::string text;
        std::size_t index = 0;
        for (const auto &[path, content] : files) {
            if (index++ >= offset && index <= offset + 3)
                text += "F" + path + "\t" + std::to_string(content.size()) + '\0';
        }
        if (text.empty())
            return EndOfFile;
        answer.set(asBytes(text));
        return NoError;
    }
    static std::uint32_t checksum(ByteView bytes)
    {
        std::uint32_t out = 0;
        for (const std::uint8_t byte : bytes) {
            out ^= byte;
            for (int i = 0; i < 8; ++i)
                out = out >> 1 ^ (out & 1 ? 0xEDB88320u : 0u);
        }
        return out;
    }

    const std::uint8_t m_traits;
    bool m_isBusy;
    std::string m_path; ///< of the open file
    std::uint8_t m_session = 0;
    std::optional<Payload> m_last;
    std::deque<Bytes> m_answers;
    Payload m_burst;
    int m_left = 0; ///< messages of the burst
};

class FileTransfers
{
public:
    explicit FileTransfers(std::uint8_t traits) : m_vehicle(traits), m_bench(m_vehicle) {}

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
        case 9: return perform(argument, in);
        default: return invent(argument, in);
        }
    }

    void perform(std::uint8_t choice, ByteReader &in)
    {
        const char *const paths[] = {"a", "b", "c", "d", "@e", "f", "new", "none"};
        const std::string path = paths[choice >> 2 & 7];
        switch (choice & 3) {
        case 0: m_bench.perform(vehicle::ReadFile{path}); return;
        case 1: m_bench.perform(vehicle::ListFolder{path}); return;
        case 2: {
            const std::size_t size = in.u16() % 4096;
            auto content = std::make_shared<Bytes>(size);
            for (std::size_t i = 0; i < size; ++i)
                (*content)[i] = static_cast<std::uint8_t>(i * 5 + choice);
            m_written[m_bench.perform(vehicle::WriteFile{path, content})] = content;
            return;
        }
        default: m_bench.perform(vehicle::RemoveFile{path}); return;
        }
    }

    /// A message of which the input tells every field.
    void invent(std::uint8_t choice, ByteReader &in)
    {
        Payload out;
        out.opcode = choice & 1 ? Nak : Ack;
        out.burstComplete = choice & 2;
        out.requested = choice >> 2 & 15;
        out.sequence = in.u16();
        out.session = in.u8();
        out.size = in.u8();
        out.offset = choice & 64 ? in.u32() : in.u8() * static_cast<std::uint32_t>(Payload::kMostData);
        std::ranges::copy(in.bytes(std::min<std::size_t>({in.remaining(), out.size, 32})), out.data.begin());
        m_bench.invent(out.message());
    }

    void judge()
    {
        for (const vehicle::FileResult &result : m_bench.takeResults()) {
            if (!result.ok || m_bench.isHostile())
                continue;
            const auto file = m_vehicle.files.find(result.path);
            const bool exists = file != m_vehicle.files.end();
            switch (result.action) {
            case vehicle::FileAction::Read:
                if (!exists || !result.content || *result.content != file->second)
                    violated("what was read is what the vehicle has");
                break;
            case vehicle::FileAction::Write:
                if (!exists || file->second != *m_written.at(result.id))
                    violated("what was written is there");
                break;
            case vehicle::FileAction::List:
                if (!result.entries || !isList(*result.entries))
                    violated("the list is that of the vehicle");
                break;
            case vehicle::FileAction::Remove:
                if (exists)
                    violated("what was removed is gone");
                break;
            }
        }
    }
    bool isList(const std::vector<vehicle::RemoteFile> &entries) const
    {
        return std::ranges::equal(entries, m_vehicle.files, [](const vehicle::RemoteFile &entry, const auto &file) {
            return entry.name == file.first && entry.size == file.second.size() && !entry.isFolder;
        });
    }

    FileVehicle m_vehicle;
    ClientBench<vehicle::FtpClient, vehicle::FileResult> m_bench;
    std::map<vehicle::RequestId, std::shared_ptr<const Bytes>> m_written;
};

} // namespace

/// The traits of the vehicle, then steps.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ByteReader in(ByteView(data, size));
    FileTransfers transfers(in.u8());
    transfers.run(in);
    return 0;
}
