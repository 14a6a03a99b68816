// The journal of a download in memory, which can be cut off at any byte as if the program had been killed.
#pragma once

#include "core/vehicle/kept_part.h"

#include <memory>

namespace skyseal::vehicle {

struct JournalSink : PartSink
{
    Bytes journal;

    void begin(std::uint32_t size, std::uint32_t stamp) override
    {
        const std::string header = partHeader("vehicle 1 file /a b", size, stamp);
        journal.assign(header.begin(), header.end());
    }
    void append(std::uint32_t offset, ByteView bytes) override
    {
        const Bytes piece = partPiece(offset, bytes);
        journal.insert(journal.end(), piece.begin(), piece.end());
    }

    /// What a program that starts again finds.
    std::shared_ptr<const KeptPart> kept() const
    {
        auto part = parsePart(journal);
        return part ? std::make_shared<const KeptPart>(std::move(*part)) : nullptr;
    }
};

inline std::size_t bytesIn(const KeptPart &part)
{
    std::size_t out = 0;
    for (const KeptPart::Piece &piece : part.pieces)
        out += piece.size;
    return out;
}

} // namespace skyseal::vehicle
