#include "core/vehicle/ftp_client.h"

#include "core/vehicle/ftp_listing.h"
#include "core/vehicle/reasons.h"
#include "core/vehicle/result_reason.h"

#include <algorithm>
#include <utility>

namespace skyseal::vehicle {

bool FtpClient::perform(TimePoint now, RequestId id, const Request &request)
{
    if (const auto *list = std::get_if<ListFolder>(&request)) {
        if (begin(now, id, FileAction::List, list->path))
            stepWithPath(now, Phase::Listing, mavlink::MAV_FTP_OPCODE_LISTDIRECTORY);
    } else if (const auto *read = std::get_if<vehicle::ReadFile>(&request)) {
        if (!begin(now, id, FileAction::Read, read->path))
            return true;
        m_transfer.setPart(read->kept, read->sink);
        stepWithPath(now, Phase::Opening, mavlink::MAV_FTP_OPCODE_OPENFILERO);
    } else if (const auto *write = std::get_if<vehicle::WriteFile>(&request)) {
        if (!begin(now, id, FileAction::Write, write->path))
            return true;
        if (!m_transfer.setSource(write->content)) {
            finish(false, nothingSent(reasons::kContentTooLarge(FileTransfer::kMostBytes)));
            return true;
        }
        stepWithPath(now, Phase::Creating, mavlink::MAV_FTP_OPCODE_CREATEFILE);
    } else if (const auto *remove = std::get_if<vehicle::RemoveFile>(&request)) {
        if (begin(now, id, FileAction::Remove, remove->path))
            stepWithPath(now, Phase::Removing, mavlink::MAV_FTP_OPCODE_REMOVEFILE);
    } else if (m_phase != Phase::Idle && !m_ended && isCancelOf(request, m_transfer.id())) {
        terminate(now, reasons::kCancelled);
    } else {
        return false;
    }
    return true;
}

bool FtpClient::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::FileTransferProtocol::kId)
        return false;
    const auto m = unpack<mavlink::FileTransferProtocol>(frame);
    if (m_phase == Phase::Idle || !addressing().isForUs(m.target_system, m.target_component))
        return true;
    const FtpMessage answer = FtpMessage::decode(m.payload);
    if (answer.opcode != mavlink::MAV_FTP_OPCODE_ACK && answer.opcode != mavlink::MAV_FTP_OPCODE_NAK)
        return true;
    if (m_phase == Phase::Bursting)
        handleBurst(now, answer);
    else if (isTransferring())
        handleChunkAnswer(now, answer);
    else if (answer.requested == m_message.opcode && answer.sequence == static_cast<std::uint16_t>(m_message.sequence + 1))
        handleStepAnswer(now, answer);
    return true;
}

void FtpClient::handleDeadline(TimePoint now)
{
    if (m_phase == Phase::Idle)
        return;
    if (isTransferring())
        return now >= m_deadline ? giveUp(now) : requestChunks(now);
    if (now < m_repetition.due())
        return;
    if (now >= m_deadline && m_repetition.attempts() >= kAttempts)
        return giveUp(now);
    if (m_phase == Phase::Bursting && m_repetition.attempts() == 0)
        return burst(now); // it has paused: its end was lost
    transmit(now, m_message);
}

TimePoint FtpClient::nextDeadline() const
{
    if (m_phase == Phase::Idle)
        return kNever;
    return isTransferring() ? std::min(m_window.nextDeadline(), m_deadline) : m_repetition.due();
}

std::optional<TransferProgress> FtpClient::progress() const
{
    if (m_phase == Phase::Idle || m_ended)
        return std::nullopt;
    return transferred();
}

bool FtpClient::read(TimePoint now, const std::string &path, std::function<void(FileResult)> ended)
{
    if (m_phase != Phase::Idle || !begin(now, {}, FileAction::Read, path))
        return false;
    m_ended = std::move(ended);
    stepWithPath(now, Phase::Opening, mavlink::MAV_FTP_OPCODE_OPENFILERO);
    return true;
}

void FtpClient::cancelRead(TimePoint now)
{
    if (m_phase != Phase::Idle && m_ended)
        terminate(now, reasons::kCancelled);
}

/// Closes the file without waiting for an answer.
void FtpClient::terminate(TimePoint now, Reason reason, bool unfit)
{
    FtpMessage message;
    message.sequence = ++m_sequence;
    message.opcode = mavlink::MAV_FTP_OPCODE_TERMINATESESSION;
    message.session = m_session;
    transmit(now, message);
    finish(false, std::move(reason), false, unfit);
}

TransferProgress FtpClient::transferred() const
{
    if (m_phase == Phase::Listing)
        return {m_transfer.id(), m_transfer.listed(), 0};
    const std::size_t done = std::min(m_window.received() * kChunk, m_transfer.size());
    return {m_transfer.id(), done, std::max(done, m_transfer.announcedSize())};
}

bool FtpClient::begin(TimePoint now, RequestId id, FileAction action, const std::string &path)
{
    const auto refuse = [&](Reason reason) {
        report(
            FileResult{.id = id, .systemId = addressing().system, .action = action, .path = path, .reason = std::move(reason)});
        return false;
    };
    if (m_phase != Phase::Idle)
        return refuse(reasons::kFileUnderWay);
    if (path.empty() || path.size() > kMostPath || path.find('\0') != std::string::npos)
        return refuse(nothingSent(reasons::kNoPath(kMostPath)));
    m_transfer = FileTransfer(id, action, path);
    m_wasReset = false;
    m_reached = 0;
    m_session = kSession;
    if (m_sequence == 0)
        m_sequence = static_cast<std::uint16_t>(
            std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count());
    m_pace = {};
    m_requests.clear();
    m_window.setMost(action == FileAction::Write ? kWritesUnderWay : RequestWindow::kMost);
    m_window.begin();
    suppose(m_window.rtt());
    m_deadline = now + kGiveUp;
    return true;
}

/// Starts a step: a request that is repeated until it is answered.
void FtpClient::step(TimePoint now, Phase phase, FtpMessage message)
{
    m_phase = phase;
    m_repetition.begin();
    m_deadline = now + kGiveUp;
    message.sequence = ++m_sequence;
    m_message = message;
    transmit(now, message);
}

void FtpClient::stepWithPath(TimePoint now, Phase phase, std::uint8_t opcode, std::uint32_t offset)
{
    FtpMessage message;
    message.session = kSession;
    message.opcode = opcode;
    message.offset = offset;
    message.append(asBytes(m_transfer.path()));
    step(now, phase, message);
}

void FtpClient::transmit(TimePoint now, FtpMessage message)
{
    mavlink::FileTransferProtocol out;
    out.payload = message.encode();
    send(out);
    m_repetition.sent(now, m_window.rtt());
}

void FtpClient::handleStepAnswer(TimePoint now, const FtpMessage &answer)
{
    m_repetition.measure(now, m_window.rtt());
    if (answer.opcode == mavlink::MAV_FTP_OPCODE_NAK)
        return handleStepRefusal(now, answer);
    if (answer.requested == mavlink::MAV_FTP_OPCODE_RESETSESSION)
        return step(now, m_phase, m_refused);
    switch (m_phase) {
    case Phase::Listing: return handleListing(now, answer);
    case Phase::Opening: return handleOpened(now, answer);
    case Phase::Creating:
        m_session = answer.session;
        if (m_transfer.size() == 0)
            return close(now);
        m_phase = Phase::Writing;
        m_window.setCount(m_transfer.chunks());
        m_window.openUpTo(m_window.count());
        return requestChunks(now);
    case Phase::Closing: return check(now);
    case Phase::Checking:
        if (!answer.number())
            return finishUnchecked();
        return m_transfer.verify(answer.number()) ? finish(true) : finishUnfit(reasons::kChecksumsDiffer);
    case Phase::Removing: return finish(true);
    default: return;
    }
}

void FtpClient::handleStepRefusal(TimePoint now, const FtpMessage &nak)
{
    const std::uint8_t error = *nak.error();
    if (resetSessions(now, error))
        return;
    switch (m_phase) {
    case Phase::Listing:
        if (error == mavlink::MAV_FTP_ERR_EOF)
            return finish(true);
        break;
    case Phase::Closing: return check(now); // it is closed
    case Phase::Checking: return finishUnchecked();
    case Phase::Removing:
        if (error == mavlink::MAV_FTP_ERR_FILENOTFOUND && m_repetition.isRepeated())
            return finish(true); // the lost answer said that it was removed
        break;
    default: break;
    }
    finish(false, ftpErrorReason(nak));
}

/// Makes room once, and repeats the request then, if the vehicle has no session for it: in use by transfers of this station
/// that ended without a word, for which ArduPilot answers opening a file with MAV_FTP_ERR_FAIL, or by others.
bool FtpClient::resetSessions(TimePoint now, std::uint8_t error)
{
    const bool opens = m_phase == Phase::Opening || m_phase == Phase::Creating;
    if (m_wasReset || !(error == mavlink::MAV_FTP_ERR_NOSESSIONSAVAILABLE || (opens && error == mavlink::MAV_FTP_ERR_FAIL)))
        return false;
    m_wasReset = true;
    m_refused = m_message;
    FtpMessage reset;
    reset.session = kSession;
    reset.opcode = mavlink::MAV_FTP_OPCODE_RESETSESSION;
    step(now, m_phase, reset);
    return true;
}

void FtpClient::handleListing(TimePoint now, const FtpMessage &answer)
{
    FtpListing part = parseListing(answer.content());
    if (part.count == 0)
        return finish(true);
    if (!m_transfer.addEntries(std::move(part)))
        return finish(false, reasons::kFolderTooLarge(FileTransfer::kMostEntries));
    stepWithPath(now, Phase::Listing, mavlink::MAV_FTP_OPCODE_LISTDIRECTORY, m_transfer.listed());
}

void FtpClient::handleOpened(TimePoint now, const FtpMessage &answer)
{
    m_session = answer.session;
    const auto size = answer.number();
    if (!size)
        return finish(false, reasons::kSizeMissing);
    if (!m_transfer.announce(*size))
        return finish(false, reasons::kFileTooLarge(FileTransfer::kMostBytes));
    if (!m_transfer.beginPart())
        return terminate(now, reasons::kFileUnlikePart, true);
    if (m_transfer.size() == 0)
        return close(now);
    m_window.setCount(m_transfer.chunks());
    takeKept(now);
    burst(now);
}

/// Bursts go on behind the last chunk that is kept; missing bytes before it are requested like lost ones.
void FtpClient::takeKept(TimePoint now)
{
    const KeptPart *kept = m_transfer.kept();
    if (!kept)
        return;
    for (const KeptPart::Piece &piece : kept->pieces) {
        const std::size_t index = piece.offset / kChunk;
        const bool isWhole = piece.size == kChunk || piece.offset + std::size_t(piece.size) == m_transfer.size();
        if (piece.offset % kChunk != 0 || !isWhole || !m_window.arrived(now, index))
            continue;
        m_transfer.store(piece.offset, kept->bytesOf(piece));
        m_reached = std::max(m_reached, index + 1);
    }
}

/// Requests the rest of the file; then what was lost.
void FtpClient::burst(TimePoint now)
{
    if (m_reached >= m_window.count())
        return fillGaps(now);
    FtpMessage message;
    message.opcode = mavlink::MAV_FTP_OPCODE_BURSTREADFILE;
    message.session = m_session;
    message.offset = static_cast<std::uint32_t>(m_reached * kChunk);
    message.size = kChunk;
    m_pace.restart();
    step(now, Phase::Bursting, message);
}

void FtpClient::handleBurst(TimePoint now, const FtpMessage &answer)
{
    if (answer.requested != mavlink::MAV_FTP_OPCODE_BURSTREADFILE)
        return;
    if (const auto error = answer.error()) {
        // Of this burst: an earlier one may have been answered twice.
        if (answer.session != m_session)
            return;
        if (*error == mavlink::MAV_FTP_ERR_EOF && m_transfer.isEstimate() && answer.offset > 0
            && answer.offset >= m_transfer.end())
            endAt(answer.offset); // both autopilots name the offset that is the end
        if (*error == mavlink::MAV_FTP_ERR_EOF || *error == mavlink::MAV_FTP_ERR_UNKNOWNCOMMAND)
            return fillGaps(now);
        return finish(false, ftpErrorReason(answer));
    }
    const std::size_t index = answer.offset / kChunk;
    if (answer.session != m_session || index > m_reached + kMostJump)
        return;
    // The messages of a burst are numbered from its request on. By this they differ from late ones of another file, whose
    // transfer was cancelled, since vehicles use the same session again.
    const std::uint32_t place = (answer.offset - m_message.offset) / kChunk;
    if (static_cast<std::uint16_t>(answer.sequence - m_message.sequence - 1) != static_cast<std::uint16_t>(place))
        return;
    if (index == m_message.offset / kChunk)
        m_repetition.measure(now, m_window.rtt());
    m_pace.arrived(now);
    if (!takeChunk(now, answer.offset, answer.content()))
        return;
    m_reached = std::max(m_reached, index + 1);
    m_repetition.begin();
    m_repetition.postpone(now + std::max({m_pace.pause(), m_window.rtt().timeout(), kLeastPause}));
    if (answer.burstComplete || m_window.isComplete())
        burst(now);
}

/// The bursts are over.
void FtpClient::fillGaps(TimePoint now)
{
    if (m_window.isComplete())
        return close(now);
    m_phase = Phase::Reading;
    m_deadline = now + kGiveUp;
    m_window.openUpTo(m_window.count());
    requestChunks(now);
}

void FtpClient::requestChunks(TimePoint now)
{
    while (const auto index = m_window.poll(now)) {
        FtpMessage message;
        message.sequence = ++m_sequence;
        message.session = m_session;
        message.offset = static_cast<std::uint32_t>(*index * kChunk);
        if (m_phase == Phase::Writing) {
            message.opcode = mavlink::MAV_FTP_OPCODE_WRITEFILE;
            message.append(m_transfer.sourceChunk(*index));
        } else {
            message.opcode = mavlink::MAV_FTP_OPCODE_READFILE;
            message.size = kChunk;
        }
        m_requests.sent(message.sequence, *index);
        mavlink::FileTransferProtocol out;
        out.payload = message.encode();
        send(out);
    }
}

void FtpClient::handleChunkAnswer(TimePoint now, const FtpMessage &answer)
{
    const bool isWrite = m_phase == Phase::Writing;
    const auto index = m_requests.answeredBy(answer.sequence);
    if (answer.requested != (isWrite ? mavlink::MAV_FTP_OPCODE_WRITEFILE : mavlink::MAV_FTP_OPCODE_READFILE) || !index
        || answer.session != m_session || *index >= m_window.count())
        return;
    if (answer.error() == mavlink::MAV_FTP_ERR_EOF && !isWrite) {
        if (!endAt(*index * kChunk))
            return;
    } else if (answer.error()) {
        return finish(false, ftpErrorReason(answer));
    } else if (isWrite) {
        if (m_window.arrived(now, *index))
            m_deadline = now + kGiveUp;
    } else if (!takeChunk(now, static_cast<std::uint32_t>(*index * kChunk), answer.content())) {
        return;
    }
    if (m_window.isComplete() || m_window.count() == 0)
        return close(now);
    requestChunks(now);
}

bool FtpClient::takeChunk(TimePoint now, std::uint32_t offset, ByteView data)
{
    const std::size_t index = offset / kChunk;
    if (offset % kChunk != 0 || index >= m_window.count() || data.empty())
        return true; // not a whole chunk: it is requested again
    const std::size_t end = offset + data.size();
    if (data.size() < kChunk && end != m_transfer.size() && !endAt(end))
        return false;
    if (index >= m_window.count() || !m_window.arrived(now, index))
        return true;
    m_transfer.take(offset, data);
    m_deadline = now + kGiveUp;
    return true;
}

/// The file ends sooner than it was announced. Returns false, and ends the transfer, if it was longer before.
bool FtpClient::endAt(std::size_t bytes)
{
    if (!m_transfer.endAt(bytes)) {
        finishUnfit(reasons::kFileChanged);
        return false;
    }
    m_window.setCount(m_transfer.chunks());
    m_window.openUpTo(m_window.count());
    return true;
}

void FtpClient::close(TimePoint now)
{
    FtpMessage message;
    message.opcode = mavlink::MAV_FTP_OPCODE_TERMINATESESSION;
    message.session = m_session;
    step(now, Phase::Closing, message);
}

/// Of a virtual file, ArduPilot would compute the checksum of newly generated contents.
void FtpClient::check(TimePoint now)
{
    if (m_transfer.isVirtual())
        return finish(true);
    stepWithPath(now, Phase::Checking, mavlink::MAV_FTP_OPCODE_CALCFILECRC);
}

/// The vehicle computes no checksum: a part that is kept may be of an older file.
void FtpClient::finishUnchecked()
{
    if (m_transfer.kept())
        return finishUnfit(reasons::kPartUnchecked);
    finish(true);
}

void FtpClient::finish(bool ok, Reason reason, bool changeUnanswered, bool unfit)
{
    FileResult result = m_transfer.takeResult(ok);
    result.systemId = addressing().system;
    result.reason = std::move(reason);
    result.changeUnanswered = changeUnanswered;
    result.unfit = unfit;
    m_phase = Phase::Idle;
    m_deadline = kNever;
    m_repetition.stop();
    if (const auto ended = std::exchange(m_ended, nullptr))
        ended(std::move(result));
    else
        report(std::move(result));
}

void FtpClient::giveUp(TimePoint now)
{
    switch (m_phase) {
    case Phase::Closing: return check(now); // what was to be transferred is there
    case Phase::Checking:
        if (m_transfer.kept())
            return finish(false, reasons::kChecksumMissing);
        return finish(true);
    case Phase::Reading:
    case Phase::Bursting: return finish(false, reasons::kByteMissing(m_window.firstMissing() * kChunk));
    case Phase::Writing: return finish(false, reasons::kByteNotAccepted(m_window.firstMissing() * kChunk));
    default: break;
    }
    const bool isChange = m_transfer.action() == FileAction::Write || m_transfer.action() == FileAction::Remove;
    finish(false, reasons::kNoAnswer(m_repetition.attempts()), isChange);
}

} // namespace skyseal::vehicle
