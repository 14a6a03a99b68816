#include "core/vehicle/kept_part.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"
#include "core/mavlink/ftp_message.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace skyseal::vehicle {

namespace {

constexpr std::string_view kMagic = "skyseal part 1 ";
constexpr std::size_t kPieceHeader = 10;

/// Takes a number and the blank behind it from the front of a text; nullopt if there is none.
std::optional<std::uint32_t> takeNumber(std::string_view &text)
{
    std::uint32_t out = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error != std::errc() || end == text.data() + text.size() || *end != ' ')
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
    return out;
}

std::optional<KeptPart> parseHeader(std::string_view text)
{
    const std::size_t end = text.find('\n');
    if (!text.starts_with(kMagic) || end == std::string_view::npos)
        return std::nullopt;
    KeptPart out;
    out.journalSize = end + 1;
    text = text.substr(0, end);
    text.remove_prefix(kMagic.size());
    const auto size = takeNumber(text), stamp = takeNumber(text);
    if (!size || !stamp || *size > KeptPart::kMostBytes)
        return std::nullopt;
    out.size = *size;
    out.stamp = *stamp;
    out.source = text;
    return out;
}

std::uint32_t checksumOf(ByteView numbers, ByteView bytes)
{
    return mavlink::ftpChecksum(bytes, mavlink::ftpChecksum(numbers));
}

} // namespace

std::string partHeader(std::string_view source, std::uint32_t size, std::uint32_t stamp)
{
    return std::string(kMagic) + std::to_string(size) + ' ' + std::to_string(stamp) + ' ' + std::string(source) + '\n';
}

Bytes partPiece(std::uint32_t offset, ByteView bytes)
{
    Bytes out(kPieceHeader + bytes.size());
    ByteWriter writer(out);
    writer.u32(offset);
    writer.u16(static_cast<std::uint16_t>(bytes.size()));
    writer.u32(checksumOf(writer.written(), bytes));
    writer.bytes(bytes);
    return out;
}

std::optional<KeptPart> parsePart(ByteView journal)
{
    auto out = parseHeader(asText(journal));
    if (!out)
        return std::nullopt;
    ByteReader in(journal.subspan(out->journalSize));
    for (;;) {
        const ByteView numbers = in.bytes(6);
        ByteReader reader(numbers);
        const std::uint32_t offset = reader.u32();
        const std::uint16_t size = reader.u16();
        const std::uint32_t checksum = in.u32();
        const ByteView bytes = in.bytes(size);
        if (!in.ok() || size == 0 || size > KeptPart::kMostPiece || offset > out->size || size > out->size - offset
            || checksum != checksumOf(numbers, bytes))
            return out;
        out->content.resize(std::max<std::size_t>(out->content.size(), offset + std::size_t(size)));
        std::ranges::copy(bytes, out->content.begin() + offset);
        out->pieces.push_back({offset, size});
        out->journalSize += kPieceHeader + size;
    }
}

} // namespace skyseal::vehicle
