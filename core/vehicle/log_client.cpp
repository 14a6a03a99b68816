#include "core/vehicle/log_client.h"

#include "core/vehicle/reasons.h"

#include <algorithm>
#include <utility>

namespace skyseal::vehicle {

bool LogClient::perform(TimePoint now, RequestId id, const Request &request)
{
    if (std::holds_alternative<ListLogs>(request)) {
        if (begin(now, id, LogAction::List))
            requestList(now);
    } else if (const auto *read = std::get_if<ReadLog>(&request)) {
        if (!begin(now, id, LogAction::Read, *read))
            return true;
        if (read->log == 0 && kind().isArduPilot())
            finish(false, reasons::kNoSuchLog);
        else
            requestList(now); // for its size
    } else if (std::holds_alternative<EraseLogs>(request)) {
        if (!begin(now, id, LogAction::Erase))
            return true;
        send(mavlink::LogErase{});
        m_deadline = now + kEraseTimeout;
        requestList(now);
    } else if (m_phase != Phase::Idle && isCancelOf(request, m_request)) {
        finish(false, reasons::kCancelled);
    } else {
        return false;
    }
    return true;
}

bool LogClient::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    switch (frame.messageId()) {
    case mavlink::LogEntry::kId:
        if (m_phase == Phase::Listing)
            handleEntry(now, unpack<mavlink::LogEntry>(frame));
        return true;
    case mavlink::LogData::kId:
        if (m_phase == Phase::Reading)
            handleData(now, unpack<mavlink::LogData>(frame));
        return true;
    default: return false;
    }
}

void LogClient::handleDeadline(TimePoint now)
{
    if (m_phase == Phase::Idle)
        return;
    if (now >= m_deadline) {
        if (m_action == LogAction::Erase)
            return finish(false, reasons::kLogsRemain, true);
        if (m_phase == Phase::Listing)
            return finish(false,
                          kind().isArduPilot() && state().armed ? reasons::kLogsNotListedArmed : reasons::kLogsNotListed);
        return finish(false, reasons::kBytesMissing(m_content.pieceOffset()));
    }
    if (m_phase == Phase::Reading)
        steer(now);
    if (now < m_repeat)
        return;
    ++m_silent;
    if (m_phase == Phase::Listing)
        requestList(now);
    else
        requestPiece(now);
}

TimePoint LogClient::nextDeadline() const
{
    return m_phase == Phase::Idle ? kNever : std::min({m_repeat, m_deadline, m_sweep.nextDeadline()});
}

std::optional<TransferProgress> LogClient::progress() const
{
    switch (m_phase) {
    case Phase::Idle: return std::nullopt;
    case Phase::Listing: return TransferProgress{m_request, m_entries.size(), m_announced.value_or(0)};
    case Phase::Reading: break;
    }
    return TransferProgress{m_request, m_content.received(), m_content.size()};
}

bool LogClient::begin(TimePoint now, RequestId id, LogAction action, ReadLog log)
{
    if (m_phase != Phase::Idle) {
        report(LogResult{
            .id = id, .systemId = addressing().system, .action = action, .log = log.log, .reason = reasons::kLogsUnderWay});
        return false;
    }
    m_request = id;
    m_action = action;
    m_log = log.log;
    m_kept = std::move(log.kept);
    m_sink = std::move(log.sink);
    m_phase = Phase::Listing;
    m_entries.clear();
    m_announced.reset();
    m_content = {};
    m_pace = {};
    m_silent = 0;
    suppose(m_rtt);
    m_deadline = now + kGiveUp;
    return true;
}

void LogClient::requestList(TimePoint now)
{
    mavlink::LogRequestList request;
    // Of a log to be read only its own entry is needed; whether there is one shows the whole list.
    const bool one = m_action == LogAction::Read && m_silent == 0;
    request.start = one ? m_log : 0;
    request.end = one ? m_log : 0xFFFF;
    send(request);
    if (one && !kind().isArduPilot()) // a lost one costs a timeout; ArduPilot complains of the second
        send(request);
    m_pace.restart();
    m_firstRequested.reset();
    rest(now);
}

/// Waits for the answer to a request; longer and longer when several got none.
void LogClient::rest(TimePoint now)
{
    m_requested = now;
    const Duration first = m_rtt.timeout();
    m_repeat = now + std::min(first * (1 << std::clamp(m_silent - kPatience, 0, 3)), RttEstimator::kMostTimeout);
}

void LogClient::handleEntry(TimePoint now, const mavlink::LogEntry &entry)
{
    if (m_pace.isWaiting() && m_silent == 0)
        m_rtt.measure(now - m_requested);
    m_pace.arrived(now);
    m_silent = 0;
    if (entry.num_logs == 0) {
        m_entries.clear();
        m_announced = 0;
        return handleListed(now);
    }
    m_announced = entry.num_logs;
    if (m_action == LogAction::Read && entry.last_log_num < m_log && !(entry.id == m_log && entry.size > 0))
        return finish(false, reasons::kNoSuchLog);
    if (m_entries.size() < kMostLogs && m_entries.emplace(entry.id, OnboardLog{entry.id, entry.size, entry.time_utc}).second
        && m_action != LogAction::Erase)
        m_deadline = now + kGiveUp;
    m_repeat = now + std::max(m_pace.pause(), RttEstimator::kFirstTimeout);
    if (m_action == LogAction::Read ? entry.id == m_log : m_entries.size() >= std::min<std::size_t>(entry.num_logs, kMostLogs))
        handleListed(now);
}

void LogClient::handleListed(TimePoint now)
{
    switch (m_action) {
    case LogAction::List: return finish(true);
    case LogAction::Erase:
        if (*m_announced == 0)
            return finish(true);
        m_entries.clear(); // not yet: the list is requested again
        m_repeat = now + RttEstimator::kFirstTimeout * 2;
        return;
    case LogAction::Read: break;
    }
    const auto entry = m_entries.find(m_log);
    if (entry == m_entries.end())
        return finish(false, reasons::kNoSuchLog);
    if (entry->second.size > kMostBytes)
        return finish(false, reasons::kLogTooLarge(kMostBytes));
    if (!beginPart(entry->second))
        return finishUnfit(reasons::kLogUnlikePart);
    m_content = LogContent(entry->second.size);
    if (m_content.size() == 0 || !takeKept())
        return finish(true);
    m_phase = Phase::Reading;
    m_pace = {};
    m_deadline = now + kGiveUp;
    requestPiece(now);
}

/// Tells the sink what begins. Returns false if what is kept is of another log, or of one that cannot be told from others.
bool LogClient::beginPart(const OnboardLog &log)
{
    if (m_kept)
        return m_kept->size == log.size && m_kept->stamp == log.timeSeconds && log.timeSeconds != 0;
    if (m_sink)
        m_sink->begin(log.size, log.timeSeconds);
    return true;
}

/// Returns false if nothing is missing. The kept part arrives piece by piece.
bool LogClient::takeKept()
{
    if (!m_kept)
        return true;
    for (const KeptPart::Piece &piece : m_kept->pieces) {
        const bool isWhole = piece.size == kChunk || piece.offset + std::size_t(piece.size) == m_content.size();
        if (piece.offset % kChunk == 0 && isWhole)
            m_content.store(piece.offset / kChunk, m_kept->bytesOf(piece));
        if (m_content.isPieceComplete() && !m_content.beginNextPiece())
            return false;
    }
    return true;
}

/// Requests what is missing of the piece.
void LogClient::requestPiece(TimePoint now)
{
    const auto first = m_content.missingFrom(0);
    if (kind().isArduPilot()) {
        requestRuns();
    } else if (first) {
        requestStream(first->first);
        m_sweep.begin(now, m_content);
        if (m_silent > kPatience)
            m_sweep.stop();
    }
    m_firstRequested = m_silent == 0 && first ? std::optional(first->first) : std::nullopt;
    m_pace.restart();
    rest(now);
}

void LogClient::requestRuns()
{
    const auto runs = m_content.missing(kMostRuns);
    const bool isWhole = runs.size() == 1 && runs[0].end - runs[0].first > kLong;
    const int copies = runs.size() <= kAskedTwice && !isWhole ? 2 : 1;
    for (int copy = 0; copy < copies; ++copy) {
        for (const LogContent::Run &run : runs)
            requestRun(run);
    }
}

void LogClient::steer(TimePoint now)
{
    const auto chunk = m_sweep.poll(now, m_content, m_rtt.shortest() == Duration::zero() ? m_rtt.timeout() : m_rtt.shortest());
    if (chunk)
        requestStream(*chunk);
}

/// Of a vehicle other than ArduPilot, which streams until the next request. The second copy replaces the first one there.
void LogClient::requestStream(std::size_t first)
{
    for (int copy = 0; copy < kStreamCopies; ++copy)
        requestRun({first, m_content.pieceEnd()});
}

void LogClient::requestRun(const LogContent::Run &run)
{
    mavlink::LogRequestData request;
    m_lastRequested = run.end - 1;
    request.id = m_log;
    request.ofs = static_cast<std::uint32_t>(run.first * kChunk);
    request.count = static_cast<std::uint32_t>(std::min(run.end * kChunk, m_content.size()) - run.first * kChunk);
    send(request);
}

void LogClient::handleData(TimePoint now, const mavlink::LogData &data)
{
    const std::size_t index = data.ofs / kChunk;
    const std::size_t count = std::min<std::size_t>(data.count, kChunk);
    if (data.id != m_log || data.ofs % kChunk != 0 || !m_content.isInPiece(index))
        return;
    if (m_pace.isWaiting() && m_firstRequested && index - *m_firstRequested < kFirstOnes)
        m_rtt.measure(now - m_requested);
    m_pace.arrived(now);
    m_sweep.arrived(now, index);
    m_silent = 0;
    m_repeat = now + std::max({m_pace.pause(), m_rtt.timeout(), kLeastPause});
    if (count < kChunk && data.ofs + count < m_content.size() && !m_content.endAt(data.ofs + count))
        return finishUnfit(reasons::kLogChanged);
    const ByteView bytes = ByteView(data.data).first(count);
    const bool isNew = m_content.store(index, bytes);
    if (isNew)
        m_deadline = now + kGiveUp;
    if (isNew && m_sink && !bytes.empty())
        m_sink->append(data.ofs, bytes);
    if (!m_content.isPieceComplete()) {
        if (isNew && index == m_lastRequested && m_sweep.nextDeadline() == kNever)
            requestPiece(now);
        return;
    }
    if (!m_content.beginNextPiece())
        return finish(true);
    requestPiece(now);
}

void LogClient::finish(bool ok, Reason reason, bool changeUnanswered, bool unfit)
{
    LogResult result{.id = m_request, .systemId = addressing().system, .action = m_action, .log = m_log, .ok = ok};
    result.reason = std::move(reason);
    result.changeUnanswered = changeUnanswered;
    result.unfit = unfit;
    if (ok && m_action == LogAction::List) {
        auto list = std::make_shared<std::vector<OnboardLog>>();
        for (const auto &[id, entry] : m_entries)
            list->push_back(entry);
        result.entries = std::move(list);
    }
    if (ok && m_action == LogAction::Read)
        result.content = std::make_shared<const Bytes>(m_content.take());
    if (m_phase == Phase::Reading || (m_action == LogAction::Read && !ok))
        send(mavlink::LogRequestEnd{});
    m_entries.clear();
    m_content = {};
    m_sweep = {};
    m_kept.reset();
    m_sink.reset();
    m_phase = Phase::Idle;
    m_repeat = m_deadline = kNever;
    report(std::move(result));
}

} // namespace skyseal::vehicle
