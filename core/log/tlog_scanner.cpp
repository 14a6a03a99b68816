#include "core/log/tlog_scanner.h"

#include <algorithm>

namespace skyseal::tlog {

using mavlink::BufferEnd;
using mavlink::Frame;
using mavlink::FrameFault;
using mavlink::isMagic;

namespace {

constexpr std::size_t kLongestEntry = kTimeLength + mavlink::kMaxFrameLength;

} // namespace

std::optional<TlogItem> TlogScanner::next()
{
    const std::size_t left = m_buffer.size() - m_position;
    if (left == 0)
        return std::nullopt;
    if (left <= kTimeLength)
        return m_end == BufferEnd::Open ? std::nullopt : damaged(FrameFault::Truncated);
    const auto frame = mavlink::readFrame(m_buffer.subspan(m_position + kTimeLength), *m_dialect);
    if (frame)
        return take(*frame, {}, kTimeLength + frame->bytes().size());
    const auto [fault, length] = frame.error();
    switch (fault) {
    case FrameFault::UnknownIncompatFlags: return take(std::nullopt, fault, kTimeLength + length);
    case FrameFault::UnknownMessage: return unknown(kTimeLength + length);
    case FrameFault::Truncated:
        if (m_end == BufferEnd::Open)
            return std::nullopt;
        return damaged(fault);
    default: return damaged(fault);
    }
}

/// Handles an entry of an unknown message, whose checksum cannot be verified. It is accepted when another entry or the end of
/// the file follows and no valid frame begins inside it.
std::optional<TlogItem> TlogScanner::unknown(std::size_t length)
{
    const std::size_t end = m_position + length;
    const bool isLast = end == m_buffer.size() && m_end == BufferEnd::Final;
    if (!isLast && end + kTimeLength >= m_buffer.size())
        return m_end == BufferEnd::Open ? std::nullopt : damaged(FrameFault::Garbage);
    if (!isLast && !(isMagic(m_buffer[end + kTimeLength]) && readTime(m_buffer.subspan(end))))
        return damaged(FrameFault::Garbage);
    for (std::size_t at = m_position; at < end; ++at) {
        if (!isMagic(m_buffer[at]))
            continue;
        const auto frame = mavlink::readFrame(m_buffer.subspan(at), *m_dialect);
        if (frame)
            return damaged(FrameFault::Garbage);
        if (frame.error().fault == FrameFault::Truncated && m_end == BufferEnd::Open)
            return std::nullopt; // more bytes may complete a valid frame
    }
    return take(std::nullopt, FrameFault::UnknownMessage, length);
}

/// Searches for the next valid frame. Its timestamp are the eight bytes before it, if they are inside the spot.
std::optional<TlogItem> TlogScanner::damaged(FrameFault fault)
{
    std::size_t at = m_position;
    for (; at < m_buffer.size(); ++at) {
        if (!isMagic(m_buffer[at]))
            continue;
        const auto frame = mavlink::readFrame(m_buffer.subspan(at), *m_dialect);
        if (frame && at < m_position + kTimeLength) {
            // The timestamp is truncated; the frame itself is valid.
            m_position = at + frame->bytes().size();
            return TlogItem{*frame, {}, std::nullopt, at, frame->bytes().size(), frame->bytes()};
        }
        if (frame)
            return take(std::nullopt, fault, at - kTimeLength - m_position);
        if (frame.error().fault == FrameFault::Truncated && m_end == BufferEnd::Open)
            break;
    }
    if (m_end == BufferEnd::Final)
        return take(std::nullopt, fault, m_buffer.size() - m_position);
    // Keep a possible entry that is not complete yet; everything before it is damage.
    const std::size_t sure = at > m_position + kTimeLength ? at - kTimeLength - m_position : 0;
    if (sure > 0)
        return take(std::nullopt, fault, sure);
    // Give up on an incomplete entry that is longer than any entry can be, or it would block the scanner.
    return m_buffer.size() - m_position > kLongestEntry + kTimeLength ? std::optional(take(std::nullopt, fault, 1))
                                                                      : std::nullopt;
}

TlogItem TlogScanner::take(std::optional<Frame> frame, FrameFault fault, std::size_t length)
{
    const ByteView whole = m_buffer.subspan(m_position, length);
    const bool extentIsSure = frame || fault == FrameFault::UnknownMessage || fault == FrameFault::UnknownIncompatFlags;
    TlogItem item{frame, fault, extentIsSure ? readTime(whole) : std::nullopt, m_position, length, {}};
    item.bytes = extentIsSure ? whole.subspan(kTimeLength) : whole;
    m_position += length;
    return item;
}

} // namespace skyseal::tlog
