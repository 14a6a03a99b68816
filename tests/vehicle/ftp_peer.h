// A small FTP server, written from the specification, that answers through a ScriptedPeer's link. It recognises a repeated
// request by its sequence number, and sends bursts at a steady pace.
#pragma once

#include "core/mavlink/ftp_message.h"
#include "lossy_link.h"

#include <map>
#include <string>

namespace skyseal::vehicle {

using mavlink::FtpMessage;

class FtpPeer : public ScriptedPeer
{
public:
    std::map<std::string, Bytes> files;
    std::optional<std::uint32_t> announced;         ///< instead of the size of a file that is made up
    Duration pace = std::chrono::microseconds(500); ///< of bursts
    bool knowsBursts = true;
    bool knowsChecksums = true;
    bool spoilsChecksums = false;
    std::size_t burstLength = 100; ///< chunks of a burst
    std::size_t entriesInPart = 3;
    int busy = 0; ///< so many opens find no free session
    int resets = 0;
    int sessions = 0;          ///< that are open
    std::size_t bytesSent = 0; ///< of files

    void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) override
    {
        const auto m = as<mavlink::FileTransferProtocol>(message);
        if (!m)
            return;
        const FtpMessage request = FtpMessage::decode(m->payload);
        if (m_last && m_last->sequence == static_cast<std::uint16_t>(request.sequence + 1)
            && m_last->requested == request.opcode)
            return reply(*m_last, out);
        FtpMessage answer;
        answer.sequence = static_cast<std::uint16_t>(request.sequence + 1);
        answer.session = request.session;
        answer.requested = request.opcode;
        answer.opcode = mavlink::MAV_FTP_OPCODE_ACK;
        answer.offset = request.offset;
        if (request.opcode == mavlink::MAV_FTP_OPCODE_BURSTREADFILE && knowsBursts) {
            m_burst = answer;
            m_sentInBurst = 0;
            m_due = now;
            return;
        }
        if (const auto error = serve(request, answer)) {
            answer.refuse(static_cast<mavlink::MAV_FTP_ERR>(*error));
        }
        m_last = answer;
        reply(answer, out);
    }

    void handleDeadline(TimePoint now, std::vector<ToStation> &out) override
    {
        const Bytes &content = files[m_open];
        if (m_burst.offset >= content.size()) {
            FtpMessage end = m_burst;
            end.refuse(mavlink::MAV_FTP_ERR_EOF);
            reply(end, out);
            m_due = kNever;
            return;
        }
        m_burst.size = 0;
        m_burst.append(chunkAt(content, m_burst.offset));
        bytesSent += m_burst.size;
        m_burst.burstComplete = ++m_sentInBurst == burstLength;
        reply(m_burst, out);
        m_burst.offset += m_burst.size;
        ++m_burst.sequence;
        m_due = m_burst.burstComplete ? kNever : now + pace;
    }
    TimePoint nextDeadline() const override { return m_due; }

private:
    static ByteView chunkAt(const Bytes &content, std::size_t offset)
    {
        return ByteView(content).subspan(offset, std::min(FtpMessage::kMostData, content.size() - offset));
    }

    std::optional<std::uint8_t> serve(const FtpMessage &request, FtpMessage &answer)
    {
        const std::string path(asText(request.content()));
        if (request.opcode != mavlink::MAV_FTP_OPCODE_RESETSESSION && busy > 0 && busy--)
            return mavlink::MAV_FTP_ERR_NOSESSIONSAVAILABLE;
        switch (request.opcode) {
        case mavlink::MAV_FTP_OPCODE_LISTDIRECTORY: return list(request.offset, answer);
        case mavlink::MAV_FTP_OPCODE_OPENFILERO:
            if (!files.contains(path))
                return mavlink::MAV_FTP_ERR_FILENOTFOUND;
            m_open = path;
            ++sessions;
            answer.session = 7;
            answer.appendNumber(path.starts_with('@') && announced ? *announced
                                                                   : static_cast<std::uint32_t>(files[path].size()));
            return std::nullopt;
        case mavlink::MAV_FTP_OPCODE_CREATEFILE:
            m_open = path;
            files[path].clear();
            ++sessions;
            answer.session = 7;
            return std::nullopt;
        case mavlink::MAV_FTP_OPCODE_READFILE:
            if (request.offset >= files[m_open].size())
                return mavlink::MAV_FTP_ERR_EOF;
            answer.append(chunkAt(files[m_open], request.offset));
            bytesSent += answer.size;
            return std::nullopt;
        case mavlink::MAV_FTP_OPCODE_WRITEFILE: {
            Bytes &content = files[m_open];
            content.resize(std::max<std::size_t>(content.size(), request.offset + request.size));
            std::ranges::copy(request.content(), content.begin() + request.offset);
            return std::nullopt;
        }
        case mavlink::MAV_FTP_OPCODE_REMOVEFILE:
            return files.erase(path) ? std::nullopt : std::optional<std::uint8_t>(mavlink::MAV_FTP_ERR_FILENOTFOUND);
        case mavlink::MAV_FTP_OPCODE_CALCFILECRC:
            if (!knowsChecksums)
                return mavlink::MAV_FTP_ERR_UNKNOWNCOMMAND;
            answer.appendNumber(mavlink::ftpChecksum(files[path]) + spoilsChecksums);
            return std::nullopt;
        case mavlink::MAV_FTP_OPCODE_TERMINATESESSION: --sessions; return std::nullopt;
        case mavlink::MAV_FTP_OPCODE_RESETSESSION: ++resets; return std::nullopt;
        default: return mavlink::MAV_FTP_ERR_UNKNOWNCOMMAND;
        }
    }

    std::optional<std::uint8_t> list(std::uint32_t offset, FtpMessage &answer)
    {
        std::string text;
        std::size_t index = 0;
        for (const auto &[path, content] : files) {
            if (index++ >= offset && index <= offset + entriesInPart)
                text += "F" + path + "\t" + std::to_string(content.size()) + '\0';
        }
        if (text.empty())
            return mavlink::MAV_FTP_ERR_EOF;
        answer.append(asBytes(text));
        return std::nullopt;
    }

    static void reply(const FtpMessage &answer, std::vector<ToStation> &out)
    {
        mavlink::FileTransferProtocol message;
        message.target_system = 255;
        message.target_component = 190;
        message.payload = answer.encode();
        out.push_back(send(message));
    }

    std::string m_open;
    std::optional<FtpMessage> m_last;
    FtpMessage m_burst;
    std::size_t m_sentInBurst = 0;
    TimePoint m_due = kNever;
};

} // namespace skyseal::vehicle
