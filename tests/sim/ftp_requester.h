// A client of MAVLink FTP for tests, over a link that may lose frames.
#pragma once

#include "tests/sim/test_station.h"

#include "core/base/byte_reader.h"
#include "core/mavlink/enums.h"
#include "core/sim/ftp_server.h"

namespace skyseal::sim {

/// The station's side: one request at a time, repeated until it is answered.
class FtpRequester
{
public:
    explicit FtpRequester(TestStation &station) : m_station(station) {}

    /// The answer; opcode 0 if none came in twenty attempts.
    FtpMessage request(std::uint8_t opcode, ByteView data = {}, std::uint32_t offset = 0, int size = -1)
    {
        FtpMessage message = made(opcode, data, offset, size);
        for (int tries = 0; tries < 20; ++tries) {
            m_station.forget();
            sendRaw(message);
            m_station.run(0.1);
            for (const auto &received : m_station.all<mavlink::FileTransferProtocol>()) {
                const FtpMessage reply = FtpMessage::decode(received.payload);
                if (reply.sequence == static_cast<std::uint16_t>(message.sequence + 1) && reply.requested == opcode)
                    return reply;
            }
        }
        return {};
    }
    FtpMessage request(std::uint8_t opcode, std::string_view path, std::uint32_t offset = 0)
    {
        return request(opcode, asBytes(path), offset);
    }
    bool accepted(std::uint8_t opcode, std::string_view path, std::uint32_t offset = 0)
    {
        return request(opcode, path, offset).opcode == mavlink::MAV_FTP_OPCODE_ACK;
    }
    /// The error of a refused request; -1 if it was not refused.
    int error(std::uint8_t opcode, std::string_view path, std::uint32_t offset = 0)
    {
        const FtpMessage reply = request(opcode, path, offset);
        return reply.opcode == mavlink::MAV_FTP_OPCODE_NAK && reply.size >= 1 ? reply.data[0] : -1;
    }

    FtpMessage made(std::uint8_t opcode, ByteView data = {}, std::uint32_t offset = 0, int size = -1)
    {
        FtpMessage message;
        message.sequence = m_sequence++;
        message.session = session;
        message.opcode = opcode;
        message.offset = offset;
        message.append(data);
        if (size >= 0)
            message.size = static_cast<std::uint8_t>(size);
        return message;
    }
    void sendRaw(const FtpMessage &message)
    {
        mavlink::FileTransferProtocol out;
        out.target_system = 1;
        out.target_component = 1;
        out.payload = message.encode();
        out.payload[4] = message.size; // also one that is too large
        m_station.send(out);
    }

    bool upload(std::string_view path, ByteView bytes, std::uint8_t opcode = mavlink::MAV_FTP_OPCODE_CREATEFILE)
    {
        if (!accepted(opcode, path))
            return false;
        for (std::size_t at = 0; at < bytes.size(); at += FtpMessage::kMostData) {
            const ByteView part = bytes.subspan(at, std::min(FtpMessage::kMostData, bytes.size() - at));
            if (request(mavlink::MAV_FTP_OPCODE_WRITEFILE, part, static_cast<std::uint32_t>(at)).opcode
                != mavlink::MAV_FTP_OPCODE_ACK)
                return false;
        }
        return request(mavlink::MAV_FTP_OPCODE_TERMINATESESSION).opcode == mavlink::MAV_FTP_OPCODE_ACK;
    }
    std::optional<Bytes> download(std::string_view path)
    {
        const FtpMessage opened = request(mavlink::MAV_FTP_OPCODE_OPENFILERO, path);
        if (opened.opcode != mavlink::MAV_FTP_OPCODE_ACK || opened.size != 4)
            return std::nullopt;
        Bytes out;
        for (;;) {
            const FtpMessage part = request(mavlink::MAV_FTP_OPCODE_READFILE, {}, static_cast<std::uint32_t>(out.size()), 239);
            if (part.opcode == mavlink::MAV_FTP_OPCODE_NAK && part.data[0] == mavlink::MAV_FTP_ERR_EOF)
                break;
            if (part.opcode != mavlink::MAV_FTP_OPCODE_ACK || part.offset != out.size())
                return std::nullopt;
            out.insert(out.end(), part.content().begin(), part.content().end());
        }
        request(mavlink::MAV_FTP_OPCODE_TERMINATESESSION);
        ByteReader size(ByteView(opened.data).first(4));
        return size.u32() == out.size() ? std::optional(out) : std::nullopt;
    }
    /// All entries of a folder, as they are sent.
    std::vector<std::string> list(std::string_view path)
    {
        std::vector<std::string> out;
        for (;;) {
            const FtpMessage reply = request(mavlink::MAV_FTP_OPCODE_LISTDIRECTORY, path,
                                             static_cast<std::uint32_t>(out.size()));
            if (reply.opcode != mavlink::MAV_FTP_OPCODE_ACK)
                return out;
            std::string_view text = asText(reply.content());
            for (std::size_t end; (end = text.find('\0')) != std::string_view::npos; text.remove_prefix(end + 1))
                out.emplace_back(text.substr(0, end));
            if (!text.empty())
                return {"an entry without an end"};
        }
    }

    std::uint8_t session = 0;

private:
    TestStation &m_station;
    std::uint16_t m_sequence = 65530; // wraps
};

inline Bytes someBytes(std::size_t size, std::uint64_t seed = 1)
{
    Noise dice(seed, 4);
    Bytes out(size);
    for (auto &byte : out)
        byte = static_cast<std::uint8_t>(dice.next());
    return out;
}

} // namespace skyseal::sim
