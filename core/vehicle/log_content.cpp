#include "core/vehicle/log_content.h"

#include <algorithm>
#include <utility>

namespace skyseal::vehicle {

std::size_t LogContent::received() const
{
    return std::min((m_begin + m_pieceReceived) * kChunk, m_size);
}

void LogContent::beginPiece()
{
    m_piece.assign(std::min(kPiece, (m_size + kChunk - 1) / kChunk - m_begin), false);
    m_pieceReceived = 0;
}

bool LogContent::beginNextPiece()
{
    m_begin += m_piece.size();
    if (m_begin * kChunk >= m_size)
        return false;
    beginPiece();
    return true;
}

std::vector<LogContent::Run> LogContent::missing(std::size_t most, std::size_t spanned) const
{
    std::vector<Run> out;
    for (std::size_t i = 0; i < m_piece.size() && out.size() < most; ++i) {
        if (m_piece[i])
            continue;
        const std::size_t end = endOfRun(i, spanned);
        out.push_back({m_begin + i, m_begin + end});
        i = end;
    }
    return out;
}

/// Of a run that begins at a missing chunk of the piece.
std::size_t LogContent::endOfRun(std::size_t first, std::size_t spanned) const
{
    std::size_t end = first + 1;
    for (std::size_t i = end; i < m_piece.size() && i <= end + spanned; ++i) {
        if (!m_piece[i])
            end = i + 1;
    }
    return end;
}

bool LogContent::endAt(std::size_t bytes)
{
    if (m_content.size() > bytes)
        return false;
    m_size = bytes;
    m_piece.resize((m_size + kChunk - 1) / kChunk - m_begin);
    return true;
}

bool LogContent::store(std::size_t chunk, ByteView data)
{
    if (!isInPiece(chunk) || m_piece[chunk - m_begin])
        return false;
    m_piece[chunk - m_begin] = true;
    ++m_pieceReceived;
    const std::size_t offset = chunk * kChunk;
    const std::size_t end = std::min(offset + data.size(), m_size);
    m_content.resize(std::max(m_content.size(), end));
    std::copy_n(data.begin(), end - offset, m_content.begin() + static_cast<std::ptrdiff_t>(offset));
    return true;
}

Bytes LogContent::take()
{
    m_piece.clear();
    return std::exchange(m_content, {});
}

} // namespace skyseal::vehicle
