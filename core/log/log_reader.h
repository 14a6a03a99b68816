// Reads a recording from a stream, either a .tlog or raw MAVLink bytes, and recovers every intact frame of a damaged file.
#pragma once

#include "core/log/tlog_scanner.h"

#include <atomic>
#include <istream>

namespace skyseal::tlog {

enum class LogFormat : std::uint8_t {
    Auto, ///< detected from the beginning of the stream
    Raw,  ///< frames without timestamps
    Tlog
};

/// A frame, or a damaged spot of `length` bytes.
struct LogItem
{
    std::optional<mavlink::Frame> frame; ///< valid until the next call of the reader
    mavlink::FrameFault fault{};         ///< set if there is no frame
    std::optional<WallTime> time;        ///< .tlog only
    std::uint64_t offset = 0;            ///< from the beginning of the stream; in a .tlog that of the timestamp
    std::uint64_t length = 0;
    ByteView bytes; ///< of the frame, also of an unknown message; empty for damage
};

class LogReader
{
public:
    /// `input` and `dialect` must outlive the reader. Reads only as much as the stream has available, so that a pipe is
    /// followed live.
    LogReader(std::istream &input, const mavlink::Dialect &dialect, LogFormat format = LogFormat::Auto);

    /// Returns the next frame or damaged spot; nullopt at the end. Contiguous damage is one spot, whatever its length.
    std::optional<LogItem> next();

    /// The stream ends for this reader once `stopped`, which must outlive it, is set by another thread: a single spot of
    /// damage may be as long as the file.
    void endWhen(const std::atomic<bool> &stopped) { m_stopped = &stopped; }
    /// Auto until the first item was read.
    LogFormat format() const { return m_format; }
    /// Bytes read so far.
    std::uint64_t bytesRead() const { return m_windowOffset + m_end; }

private:
    std::optional<LogItem> nextPiece();
    std::optional<LogItem> scanWindow();
    void findFormat();
    bool readMore();
    ByteView window() const { return ByteView(m_buffer).subspan(m_begin, m_end - m_begin); }

    std::istream &m_input;
    const mavlink::Dialect &m_dialect;
    LogFormat m_format;
    Bytes m_buffer;
    std::size_t m_begin = 0, m_end = 0; ///< unread part of the buffer
    std::uint64_t m_windowOffset = 0;   ///< offset of the buffer in the stream
    bool m_ended = false;
    const std::atomic<bool> *m_stopped = nullptr;
    std::optional<LogItem> m_damage; ///< damaged spot whose end is not known yet
    std::optional<LogItem> m_after;  ///< the item behind the damaged spot
};

} // namespace skyseal::tlog
