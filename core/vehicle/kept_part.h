// Journal of a download under way, from which an interrupted one resumes: the pieces of the file or log in the order in which
// they arrived. It only grows, so that a program may be killed at any byte of it.
//
//     "skyseal part 1 SIZE STAMP SOURCE\n", then of each piece: offset (4 bytes), size (2), checksum of offset, size and bytes
//     (4), bytes. Numbers are little endian; the checksum is that of MAVLink FTP.
#pragma once

#include "core/base/bytes.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

/// A download that was broken off.
struct KeptPart
{
    static constexpr std::size_t kMostBytes = 512u << 20; ///< of the whole
    static constexpr std::size_t kMostPiece = 255;

    struct Piece
    {
        std::uint32_t offset = 0;
        std::uint32_t size = 0;
    };

    std::string source;      ///< what it is a part of, as the journal's owner names it
    std::uint32_t size = 0;  ///< of the whole, in bytes
    std::uint32_t stamp = 0; ///< of a log, its time in seconds since 1970 UTC; 0 of a file
    Bytes content;           ///< up to the last byte that is there; zero where bytes are missing
    std::vector<Piece> pieces;
    std::size_t journalSize = 0; ///< bytes of the journal that are whole

    ByteView bytesOf(const Piece &piece) const { return ByteView(content).subspan(piece.offset, piece.size); }
};

/// Begins a journal. `source`: without a line break.
std::string partHeader(std::string_view source, std::uint32_t size, std::uint32_t stamp);
/// Of at most kMostPiece bytes.
Bytes partPiece(std::uint32_t offset, ByteView bytes);
/// Reads a journal up to the first piece that is not whole; nullopt if it is none.
std::optional<KeptPart> parsePart(ByteView journal);

/// Takes what arrives of a download. Called in the thread of the vehicle.
class PartSink
{
public:
    virtual ~PartSink() = default;
    /// Something of this size begins, of which nothing is there.
    virtual void begin(std::uint32_t size, std::uint32_t stamp) = 0;
    virtual void append(std::uint32_t offset, ByteView bytes) = 0;
};

} // namespace skyseal::vehicle
