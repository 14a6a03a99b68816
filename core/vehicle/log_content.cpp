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

std::vector<LogContent::Run> LogContent::missing(std::size_t most) const
{
    std::vector<Run> out;
    for (auto run = missingFrom(m_begin); run && out.size() < most; run = missingFrom(run->end))
        out.push_back(*run);
    return out;
}

std::optional<LogContent::Run> LogContent::missingFrom(std::size_t chunk) const
{
    const std::size_t from = std::clamp(chunk, m_begin, pieceEnd()) - m_begin;
    const auto first = std::find(m_piece.begin() + static_cast<std::ptrdiff_t>(from), m_piece.end(), false);
    if (first == m_piece.end())
        return std::nullopt;
    const auto end = std::find(first, m_piece.end(), true);
    return Run{m_begin + static_cast<std::size_t>(first - m_piece.begin()),
               m_begin + static_cast<std::size_t>(end - m_piece.begin())};
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
