// The bytes of a log that is read: a row of chunks of 90 bytes, requested in pieces. Knows which chunks of the piece are
// missing.
#pragma once

#include "core/base/bytes.h"

#include <optional>
#include <vector>

namespace skyseal::vehicle {

class LogContent
{
public:
    static constexpr std::size_t kChunk = 90;    ///< bytes of a LOG_DATA
    static constexpr std::size_t kPiece = 16384; ///< chunks that are requested at a time

    /// Chunks from `first` to before `end`.
    struct Run
    {
        std::size_t first = 0;
        std::size_t end = 0;
    };

    LogContent() = default;
    /// A log of so many bytes, of which nothing has arrived.
    explicit LogContent(std::size_t size) : m_size(size) { beginPiece(); }

    std::size_t size() const { return m_size; }
    /// Bytes that have arrived.
    std::size_t received() const;
    /// The byte with which the piece begins.
    std::size_t pieceOffset() const { return m_begin * kChunk; }
    bool isInPiece(std::size_t chunk) const { return chunk >= m_begin && chunk < m_begin + m_piece.size(); }
    bool isPieceComplete() const { return m_pieceReceived == m_piece.size(); }
    /// Begins the piece behind a complete one. Returns false if the log is complete.
    bool beginNextPiece();

    /// Runs of missing chunks of the piece, at most `most`.
    std::vector<Run> missing(std::size_t most) const;
    /// The first run of missing chunks of the piece at or behind a chunk.
    std::optional<Run> missingFrom(std::size_t chunk) const;
    /// The chunk behind the piece.
    std::size_t pieceEnd() const { return m_begin + m_piece.size(); }

    /// The log ends sooner than it was listed. Returns false if more has arrived already.
    bool endAt(std::size_t bytes);
    /// Stores a chunk. Returns false, and does nothing, if it is not of the piece or has arrived before.
    bool store(std::size_t chunk, ByteView data);
    /// Hands over all that has arrived.
    Bytes take();

private:
    void beginPiece();

    Bytes m_content; ///< complete pieces, then the one that is under way
    std::size_t m_size = 0;
    std::size_t m_begin = 0;   ///< the first chunk of the piece
    std::vector<bool> m_piece; ///< the chunks that have arrived
    std::size_t m_pieceReceived = 0;
};

} // namespace skyseal::vehicle
