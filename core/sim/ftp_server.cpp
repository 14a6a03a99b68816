#include "core/sim/ftp_server.h"

#include "core/mavlink/enums.h"

namespace skyseal::sim {

using namespace mavlink;

namespace {

constexpr Duration kBurstPace = std::chrono::milliseconds(10); // of bursts: 24 kB a second
constexpr std::uint32_t kBurst = 2000;                         // messages, as many as ArduPilot sends for one request
constexpr Duration kReusable = std::chrono::seconds(3);        // after so long a session may be taken over
constexpr Duration kAbandoned = std::chrono::seconds(20);
constexpr std::size_t kLongestUpload = 65535;

void refuse(FtpMessage &reply, FileError error)
{
    switch (error) {
    case FileError::NotFound: return reply.refuse(MAV_FTP_ERR_FILENOTFOUND);
    case FileError::Exists: return reply.refuse(MAV_FTP_ERR_FILEEXISTS);
    case FileError::Protected: return reply.refuse(MAV_FTP_ERR_FILEPROTECTED);
    default: break;
    }
    reply.refuse(MAV_FTP_ERR_FAILERRNO);
    reply.size = 2;
    reply.data[1] = static_cast<std::uint8_t>(error);
}

/// The path that a request is about: its data, of which the last byte may be a zero. Empty if it is malformed.
std::string_view pathIn(ByteView data)
{
    const std::string_view text = asText(data);
    const std::size_t length = std::min(text.find('\0'), text.size());
    return length + 1 >= text.size() ? text.substr(0, length) : std::string_view();
}

} // namespace

void FtpServer::handle(TimePoint now, const FrameSender &peer, const FtpMessage &request)
{
    if (request.opcode == MAV_FTP_OPCODE_ACK || request.opcode == MAV_FTP_OPCODE_NAK)
        return;
    closeIdle(now);
    FtpMessage reply;
    reply.sequence = static_cast<std::uint16_t>(request.sequence + 1);
    reply.session = request.session;
    reply.opcode = MAV_FTP_OPCODE_ACK;
    reply.requested = request.opcode;

    Answer *last = std::find_if(m_answers.begin(), m_answers.end(),
                                [&](const Answer &answer) { return answer.valid && answer.peer.sameSender(peer); });
    if (last == m_answers.end()) {
        last = &m_answers[m_oldestAnswer];
        m_oldestAnswer = (m_oldestAnswer + 1) % m_answers.size();
        *last = {peer, {}, false};
    }
    if (last->valid && last->message.sequence == reply.sequence && last->message.session == reply.session
        && last->message.requested == reply.requested)
        return send(peer, last->message);

    if (request.size > FtpMessage::kMostData)
        reply.refuse(MAV_FTP_ERR_INVALIDDATASIZE);
    else if (request.opcode == MAV_FTP_OPCODE_BURSTREADFILE) {
        if (beginBurst(now, use(now, peer, request.session), request, reply))
            return; // the burst is the answer
    } else
        answer(now, peer, request, reply);
    const bool mayWorkLater = reply.opcode == MAV_FTP_OPCODE_NAK && reply.data[0] == MAV_FTP_ERR_NOSESSIONSAVAILABLE;
    *last = {peer, reply, !mayWorkLater};
    send(peer, reply);
}

void FtpServer::answer(TimePoint now, const FrameSender &peer, const FtpMessage &request, FtpMessage &reply)
{
    switch (request.opcode) {
    case MAV_FTP_OPCODE_NONE: return;
    case MAV_FTP_OPCODE_TERMINATESESSION: return terminate(find(peer, request.session), reply);
    case MAV_FTP_OPCODE_RESETSESSION:
        for (Session &session : m_sessions) {
            if (session.peer.sameSender(peer))
                session = {};
        }
        return;
    case MAV_FTP_OPCODE_OPENFILERO:
    case MAV_FTP_OPCODE_OPENFILEWO:
    case MAV_FTP_OPCODE_CREATEFILE: return openFile(now, peer, request, reply);
    case MAV_FTP_OPCODE_READFILE: return readFile(use(now, peer, request.session), request, reply);
    case MAV_FTP_OPCODE_WRITEFILE: return writeFile(use(now, peer, request.session), request, reply);
    case MAV_FTP_OPCODE_RENAME: return rename(request, reply);
    default: return changeFile(request, reply);
    }
}

/// Requests about one path that need no session.
void FtpServer::changeFile(const FtpMessage &request, FtpMessage &reply)
{
    const std::string_view path = pathIn(request.content());
    const auto complete = [&](const StoreResult<void> &done) {
        if (!done)
            refuse(reply, done.error());
    };
    const auto known = request.opcode == MAV_FTP_OPCODE_LISTDIRECTORY || request.opcode == MAV_FTP_OPCODE_REMOVEFILE
        || request.opcode == MAV_FTP_OPCODE_CREATEDIRECTORY || request.opcode == MAV_FTP_OPCODE_REMOVEDIRECTORY
        || request.opcode == MAV_FTP_OPCODE_TRUNCATEFILE || request.opcode == MAV_FTP_OPCODE_CALCFILECRC;
    if (known && path.empty())
        return reply.refuse(MAV_FTP_ERR_INVALIDDATASIZE);
    switch (request.opcode) {
    case MAV_FTP_OPCODE_LISTDIRECTORY: return listDirectory(path, request.offset, reply);
    case MAV_FTP_OPCODE_REMOVEFILE: return complete(m_files.remove(path));
    case MAV_FTP_OPCODE_CREATEDIRECTORY: return complete(m_files.makeDirectory(path));
    case MAV_FTP_OPCODE_REMOVEDIRECTORY: return complete(m_files.removeDirectory(path));
    case MAV_FTP_OPCODE_TRUNCATEFILE: return complete(m_files.truncate(path, request.offset));
    case MAV_FTP_OPCODE_CALCFILECRC:
        if (const auto file = m_files.read(path))
            reply.appendNumber(ftpChecksum(*file));
        else
            refuse(reply, file.error());
        return;
    default: return reply.refuse(MAV_FTP_ERR_UNKNOWNCOMMAND);
    }
}

/// Two paths, with a zero between them.
void FtpServer::rename(const FtpMessage &request, FtpMessage &reply)
{
    const ByteView content = request.content();
    const std::string_view from = asText(content).substr(0, asText(content).find('\0'));
    const std::string_view to = pathIn(content.subspan(std::min(from.size() + 1, content.size())));
    if (from.empty() || to.empty())
        return reply.refuse(MAV_FTP_ERR_INVALIDDATASIZE);
    if (const auto done = m_files.rename(from, to); !done)
        refuse(reply, done.error());
}

void FtpServer::listDirectory(std::string_view path, std::uint32_t first, FtpMessage &reply)
{
    reply.offset = first;
    const auto entries = m_files.list(path);
    if (!entries)
        return refuse(reply, entries.error());
    for (std::size_t i = first; i < entries->size(); ++i) {
        const FileEntry &entry = (*entries)[i];
        std::string text = (entry.directory ? "D" : "F") + entry.name;
        if (!entry.directory)
            text += "\t" + std::to_string(entry.size);
        text.push_back('\0');
        if (!reply.append(asBytes(text)))
            break;
    }
    if (reply.size == 0)
        reply.refuse(MAV_FTP_ERR_EOF);
}

void FtpServer::openFile(TimePoint now, const FrameSender &peer, const FtpMessage &request, FtpMessage &reply)
{
    const std::string_view path = pathIn(request.content());
    if (path.empty())
        return reply.refuse(MAV_FTP_ERR_INVALIDDATASIZE);
    Session *session = find(peer, request.session);
    if (session && now - session->lastUse <= kReusable)
        return reply.refuse(MAV_FTP_ERR_FAIL); // one file a session
    if (!session)
        session = allocate(now);
    if (!session)
        return reply.refuse(MAV_FTP_ERR_NOSESSIONSAVAILABLE);
    Session opened;
    opened.peer = peer;
    opened.id = request.session;
    opened.lastUse = now;
    opened.path = path;
    *session = {};
    if (request.opcode == MAV_FTP_OPCODE_OPENFILERO) {
        auto content = m_files.read(path);
        if (!content)
            return refuse(reply, content.error());
        opened.content = std::move(*content);
        opened.mode = Mode::Read;
        reply.appendNumber(static_cast<std::uint32_t>(opened.content.size()));
    } else if (VehicleFiles::isParameterFile(path)) {
        opened.mode = Mode::Upload;
    } else {
        if (const auto made = m_files.create(path, request.opcode == MAV_FTP_OPCODE_CREATEFILE); !made)
            return refuse(reply, made.error());
        opened.mode = Mode::Write;
    }
    *session = std::move(opened);
}

void FtpServer::readFile(const Session *session, const FtpMessage &request, FtpMessage &reply)
{
    if (!session)
        return reply.refuse(MAV_FTP_ERR_FILENOTFOUND);
    if (session->mode != Mode::Read)
        return reply.refuse(MAV_FTP_ERR_FAIL);
    const ByteView content(session->content);
    reply.offset = request.offset;
    if (request.offset >= content.size() || request.size == 0)
        return reply.refuse(MAV_FTP_ERR_EOF);
    const ByteView rest = content.subspan(request.offset);
    reply.append(rest.first(std::min<std::size_t>(request.size, rest.size())));
}

void FtpServer::writeFile(Session *session, const FtpMessage &request, FtpMessage &reply)
{
    if (!session)
        return reply.refuse(MAV_FTP_ERR_FILENOTFOUND);
    reply.offset = request.offset;
    const ByteView bytes = request.content();
    if (session->mode == Mode::Write) {
        if (const auto written = m_files.write(session->path, request.offset, bytes); !written)
            refuse(reply, written.error());
    } else if (session->mode == Mode::Upload) {
        if (request.offset > kLongestUpload - bytes.size())
            return refuse(reply, FileError::NoSpace);
        Bytes &upload = session->content;
        upload.resize(std::max<std::size_t>(upload.size(), request.offset + bytes.size()));
        std::copy(bytes.begin(), bytes.end(), upload.begin() + request.offset);
    } else {
        reply.refuse(MAV_FTP_ERR_FAIL);
    }
}

void FtpServer::terminate(Session *session, FtpMessage &reply)
{
    if (!session)
        return; // closed already
    if (session->mode == Mode::Upload) {
        if (const auto stored = m_files.storeParameters(session->content); !stored)
            refuse(reply, stored.error());
    }
    *session = {};
}

bool FtpServer::beginBurst(TimePoint now, Session *session, const FtpMessage &request, FtpMessage &reply)
{
    if (!session) {
        reply.refuse(MAV_FTP_ERR_FILENOTFOUND);
        return false;
    }
    if (session->mode != Mode::Read) {
        reply.refuse(MAV_FTP_ERR_FAIL);
        return false;
    }
    session->burstLeft = kBurst;
    session->burstOffset = request.offset;
    session->burstSequence = reply.sequence;
    session->burstSize = request.size == 0 ? std::uint8_t(FtpMessage::kMostData) : request.size;
    if (m_due == kNever)
        m_due = now;
    return true;
}

void FtpServer::handleDeadline(TimePoint now)
{
    while (m_due <= now) {
        m_due += kBurstPace;
        if (m_outbox.room() < FrameQueue::kKeptForTelemetry)
            continue;
        std::size_t looked = 0;
        while (looked < kSessions && m_sessions[m_nextBurst].burstLeft == 0) {
            m_nextBurst = (m_nextBurst + 1) % kSessions;
            ++looked;
        }
        if (looked == kSessions) {
            m_due = kNever;
            return;
        }
        sendBurst(now, m_sessions[m_nextBurst]);
        m_nextBurst = (m_nextBurst + 1) % kSessions;
    }
}

void FtpServer::sendBurst(TimePoint now, Session &session)
{
    session.lastUse = now;
    FtpMessage message;
    message.sequence = session.burstSequence++;
    message.session = session.id;
    message.opcode = MAV_FTP_OPCODE_ACK;
    message.requested = MAV_FTP_OPCODE_BURSTREADFILE;
    message.offset = session.burstOffset;
    if (session.burstOffset >= session.content.size()) {
        message.refuse(MAV_FTP_ERR_EOF);
        message.burstComplete = true;
        session.burstLeft = 0;
    } else {
        const ByteView rest = ByteView(session.content).subspan(session.burstOffset);
        message.append(rest.first(std::min<std::size_t>(session.burstSize, rest.size())));
        session.burstOffset += message.size;
        message.burstComplete = --session.burstLeft == 0; // the station asks again
    }
    send(session.peer, message);
}

FtpServer::Session *FtpServer::find(const FrameSender &peer, std::uint8_t id)
{
    for (Session &session : m_sessions) {
        if (session.mode != Mode::Closed && session.peer.sameSender(peer) && session.id == id)
            return &session;
    }
    return nullptr;
}

FtpServer::Session *FtpServer::use(TimePoint now, const FrameSender &peer, std::uint8_t id)
{
    Session *session = find(peer, id);
    if (session)
        session->lastUse = now;
    return session;
}

FtpServer::Session *FtpServer::allocate(TimePoint now)
{
    Session *oldest = &m_sessions[0];
    for (Session &session : m_sessions) {
        if (session.mode == Mode::Closed)
            return &session;
        if (session.lastUse < oldest->lastUse)
            oldest = &session;
    }
    return now - oldest->lastUse > kReusable ? oldest : nullptr;
}

void FtpServer::closeIdle(TimePoint now)
{
    for (Session &session : m_sessions) {
        if (session.mode != Mode::Closed && now - session.lastUse > kAbandoned)
            session = {};
    }
}

std::size_t FtpServer::openSessions() const
{
    return static_cast<std::size_t>(std::count_if(m_sessions.begin(), m_sessions.end(),
                                                  [](const Session &session) { return session.mode != Mode::Closed; }));
}

void FtpServer::send(const FrameSender &peer, const FtpMessage &message)
{
    FileTransferProtocol out;
    out.target_system = peer.system;
    out.target_component = peer.component;
    out.payload = message.encode();
    m_outbox.send(out);
}

} // namespace skyseal::sim
