// Reads a recording piece by piece from a stream, be it a .tlog or bare MAVLink bytes, and loses nothing that damage has
// spared.
#pragma once

#include "core/log/tlog_scanner.h"

#include <istream>

namespace skyseal::tlog {

enum class LogFormat : std::uint8_t {
    Auto, ///< found out from the beginning
    Raw,  ///< frames one after the other
    Tlog
};

/// A frame, or a bad spot of `length` bytes.
struct LogItem
{
    std::optional<mavlink::Frame> frame; ///< lives until the reader's next step
    mavlink::FrameFault fault{};         ///< when there is no frame
    std::optional<WallTime> time;        ///< in a .tlog
    std::uint64_t offset = 0;            ///< from the beginning of the stream; of the entry with its time in a .tlog
    std::uint64_t length = 0;
    ByteView bytes; ///< of the frame, also of one whose message is unknown; empty for damage
};

class LogReader
{
public:
    /// Both must outlive the reader. The stream is read in the portions it has at hand, so that a pipe is followed live.
    LogReader(std::istream &input, const mavlink::Dialect &dialect, LogFormat format = LogFormat::Auto);

    /// The next frame or bad spot; nullopt at the end. Damage that goes on is one spot, however long it is.
    std::optional<LogItem> next();

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
    std::size_t m_begin = 0, m_end = 0; ///< what of the buffer is still to be read
    std::uint64_t m_windowOffset = 0;   ///< of the buffer's first byte in the stream
    bool m_ended = false;
    std::optional<LogItem> m_damage; ///< may still grow
    std::optional<LogItem> m_after;  ///< what ended the damage
};

} // namespace skyseal::tlog
