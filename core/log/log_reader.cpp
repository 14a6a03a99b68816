#include "core/log/log_reader.h"

#include <algorithm>
#include <utility>

namespace skyseal::tlog {

using mavlink::BufferEnd;
using mavlink::FrameFault;
using mavlink::FrameScanner;
using mavlink::ScanItem;

namespace {

constexpr std::size_t kBufferSize = 64 * 1024;
constexpr std::size_t kEnoughToTell = 4096;

bool isDamage(const LogItem &item)
{
    return !item.frame && item.fault != FrameFault::UnknownMessage && item.fault != FrameFault::UnknownIncompatFlags;
}

} // namespace

LogReader::LogReader(std::istream &input, const mavlink::Dialect &dialect, LogFormat format)
    : m_input(input), m_dialect(dialect), m_format(format), m_buffer(kBufferSize)
{}

std::optional<LogItem> LogReader::next()
{
    if (m_after)
        return std::exchange(m_after, std::nullopt);
    while (true) {
        std::optional<LogItem> piece = nextPiece();
        if (!m_damage && (!piece || !isDamage(*piece)))
            return piece;
        if (!m_damage) {
            m_damage = piece;
        } else if (piece && piece->fault == FrameFault::Garbage && !piece->frame
                   && piece->offset == m_damage->offset + m_damage->length) {
            m_damage->length += piece->length;
        } else if (piece && isDamage(*piece)) {
            return std::exchange(m_damage, piece);
        } else {
            m_after = piece;
            return std::exchange(m_damage, std::nullopt);
        }
    }
}

std::optional<LogItem> LogReader::nextPiece()
{
    while (true) {
        if (m_format == LogFormat::Auto)
            findFormat();
        if (m_format != LogFormat::Auto && m_begin < m_end) {
            if (auto item = scanWindow())
                return item;
        }
        if (m_ended)
            return std::nullopt;
        readMore();
    }
}

std::optional<LogItem> LogReader::scanWindow()
{
    const BufferEnd end = m_ended ? BufferEnd::Final : BufferEnd::Open;
    const std::uint64_t base = m_windowOffset + m_begin;
    LogItem out;
    if (m_format == LogFormat::Tlog) {
        TlogScanner scanner(window(), m_dialect, end);
        const auto item = scanner.next();
        m_begin += scanner.position();
        if (!item)
            return std::nullopt;
        out = {item->frame, item->fault, item->time, base + item->offset, item->length, item->bytes};
    } else {
        FrameScanner scanner(window(), m_dialect, end);
        const auto item = scanner.next();
        m_begin += scanner.position();
        if (!item)
            return std::nullopt;
        out = {item->frame, item->fault, std::nullopt, base + item->offset, item->bytes.size(), item->bytes};
    }
    if (isDamage(out))
        out.bytes = {};
    return out;
}

/// Detects the format: in a .tlog eight bytes precede every frame, in raw MAVLink none do.
void LogReader::findFormat()
{
    const bool isAll = m_ended || m_end - m_begin >= kEnoughToTell;
    const ByteView content = window();
    if (mavlink::readFrame(content, m_dialect)) {
        m_format = LogFormat::Raw;
    } else if (content.size() > kTimeLength && readTime(content)
               && mavlink::readFrame(content.subspan(kTimeLength), m_dialect)) {
        m_format = LogFormat::Tlog;
    } else if (isAll) {
        FrameScanner scanner(content, m_dialect);
        std::size_t lastEnd = 0, raw = 0, timed = 0;
        bool first = true;
        while (const auto item = scanner.next()) {
            if (!item->frame)
                continue;
            const std::size_t gap = item->offset - lastEnd;
            raw += gap == 0 && !first;
            timed += gap == kTimeLength
                || (first && gap > kTimeLength && readTime(content.subspan(item->offset - kTimeLength)));
            lastEnd = item->offset + item->bytes.size();
            first = false;
        }
        m_format = timed > raw ? LogFormat::Tlog : LogFormat::Raw;
    }
}

bool LogReader::readMore()
{
    if (m_begin > 0) {
        std::copy(m_buffer.begin() + static_cast<std::ptrdiff_t>(m_begin),
                  m_buffer.begin() + static_cast<std::ptrdiff_t>(m_end), m_buffer.begin());
        m_windowOffset += m_begin;
        m_end -= m_begin;
        m_begin = 0;
    }
    if (m_stopped && *m_stopped) {
        m_ended = true;
        return false;
    }
    // Read only what is available without waiting, but at least the byte that peek() returned.
    const std::size_t room = m_buffer.size() - m_end;
    if (room == 0 || m_input.peek() == std::istream::traits_type::eof()) {
        m_ended = true;
        return false;
    }
    const auto atHand = std::clamp<std::streamsize>(m_input.rdbuf()->in_avail(), 1, static_cast<std::streamsize>(room));
    m_input.read(reinterpret_cast<char *>(m_buffer.data() + m_end), atHand);
    m_end += static_cast<std::size_t>(m_input.gcount());
    return true;
}

} // namespace skyseal::tlog
