#include "core/link/tlog_link.h"

#include "core/link/steady_now.h"
#include "core/log/open_log.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/frame.h"

#include <algorithm>

namespace skyseal::link {

static constexpr std::size_t kBatch = 64;

struct TlogLink::Frames
{
    struct Slot
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> bytes;
        std::size_t length = 0;
    };
    Slot ahead; ///< read, but not yet due
    bool hasAhead = false;
    std::array<Slot, kBatch> due;
    std::array<ReceivedBlock, kBatch> blocks;
};

TlogLink::TlogLink(LinkUrl linkUrl, LinkId linkId, LinkListener &linkListener, LinkOptions linkOptions)
    : Link(std::move(linkUrl), linkId, linkListener, linkOptions), m_frames(std::make_unique<Frames>())
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &TlogLink::play);
}

TlogLink::~TlogLink() = default;

void TlogLink::open()
{
    if (state() != LinkState::Closed && state() != LinkState::Failed && state() != LinkState::Ended)
        return;
    const std::string &path = url().path();
    auto file = tlog::openLog(path);
    if (!file) {
        setState(LinkState::Failed, {LinkErrorCode::FileUnreadable, path, file.error()});
        return;
    }
    m_file = std::move(*file);
    m_reader = std::make_unique<tlog::LogReader>(m_file, mavlink::Dialect::builtin());
    m_frames->hasAhead = false;
    m_line = {};
    m_nextAt = {};
    m_hasFrame = false;
    m_startedAt = steadyNow();
    setState(LinkState::Connected);
    m_timer.start(0);
}

bool TlogLink::readNext()
{
    while (const auto item = m_reader->next()) {
        // Damaged spots have no bytes; frames of unknown messages do, and are replayed.
        if (item->bytes.empty() || item->bytes.size() > m_frames->ahead.bytes.size()) {
            ++m_counters.rxErrors;
            continue;
        }
        std::copy(item->bytes.begin(), item->bytes.end(), m_frames->ahead.bytes.begin());
        m_frames->ahead.length = item->bytes.size();
        m_hasFrame = m_hasFrame || item->frame;
        const Duration before = m_line.position();
        m_nextAt += std::min<Duration>(m_line.note(item->time) - before, tlog::LogTime::kLongestWait);
        return true;
    }
    return false;
}

TimePoint TlogLink::due() const
{
    if (options().replayFactor <= 0)
        return m_startedAt;
    return m_startedAt + std::chrono::duration_cast<Duration>(m_nextAt / options().replayFactor);
}

void TlogLink::play()
{
    const TimePoint now = steadyNow();
    std::size_t used = 0;
    bool ended = false;
    while (used < kBatch) {
        if (!m_frames->hasAhead && !(m_frames->hasAhead = readNext())) {
            ended = true;
            break;
        }
        if (due() > now)
            break;
        Frames::Slot &slot = m_frames->due[used];
        slot = m_frames->ahead;
        m_frames->hasAhead = false;
        m_frames->blocks[used++] = {{id(), {}}, MutableByteView(slot.bytes).first(slot.length), now};
        ++m_counters.rxBlocks;
        m_counters.rxBytes += slot.length;
    }
    if (used > 0)
        listener().linkReceived(*this, {m_frames->blocks.data(), used});
    if (state() != LinkState::Connected)
        return;
    if (ended && !m_hasFrame) {
        setState(LinkState::Failed, {LinkErrorCode::FileUnreadable, url().path(), tlog::kNoFrame});
        return;
    }
    if (ended) {
        setState(LinkState::Ended, {LinkErrorCode::EndOfFile, url().path(), {}});
        return;
    }
    const Duration wait = m_frames->hasAhead ? due() - steadyNow() : Duration(0);
    m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(std::clamp(wait, Duration(0), Duration(std::chrono::hours(1)))));
}

void TlogLink::close()
{
    m_timer.stop();
    m_file.close();
    setState(LinkState::Closed);
}

} // namespace skyseal::link

#include "moc_tlog_link.cpp"
