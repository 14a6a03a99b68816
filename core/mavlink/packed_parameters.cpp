#include "core/mavlink/packed_parameters.h"

#include "core/base/byte_reader.h"
#include "core/mavlink/enums.h"

#include <algorithm>
#include <bit>

namespace skyseal::mavlink {

namespace {

constexpr std::uint8_t kHasDefault = 1; // of the flags
constexpr std::size_t kLongestName = 16;
constexpr std::size_t kLeastEntry = 4; // type, lengths, one character, one byte

struct Value
{
    std::uint8_t type;
    double value;
};

std::optional<Value> readValue(ByteReader &in, std::uint8_t type)
{
    switch (type) {
    case kPackedInt8: return Value{MAV_PARAM_TYPE_INT8, static_cast<double>(in.littleEndian<std::int8_t>())};
    case kPackedInt16: return Value{MAV_PARAM_TYPE_INT16, static_cast<double>(in.littleEndian<std::int16_t>())};
    case kPackedInt32: return Value{MAV_PARAM_TYPE_INT32, static_cast<double>(in.littleEndian<std::int32_t>())};
    case kPackedFloat: return Value{MAV_PARAM_TYPE_REAL32, static_cast<double>(std::bit_cast<float>(in.u32()))};
    default: return std::nullopt;
    }
}

} // namespace

std::optional<PackedParameters> parsePackedParameters(ByteView file)
{
    ByteReader in(file);
    PackedParameters out;
    const std::uint16_t magic = in.u16(), count = in.u16();
    out.total = in.u16();
    out.hasDefaults = magic == kPackedMagicWithDefaults;
    if (!in.ok() || (magic != kPackedMagic && !out.hasDefaults))
        return std::nullopt;
    out.parameters.reserve(std::min<std::size_t>(count, in.remaining() / kLeastEntry));
    std::string name;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint8_t first = in.u8();
        while (first == 0 && !in.atEnd()) // padding
            first = in.u8();
        const std::uint8_t type = first & 0xf, flags = first >> 4, lengths = in.u8();
        const std::size_t shared = lengths & 0xf, added = (lengths >> 4) + std::size_t(1);
        if (shared > name.size() || shared + added > kLongestName)
            return std::nullopt;
        name.resize(shared);
        name += asText(in.bytes(added));
        const auto value = readValue(in, type);
        if ((flags & kHasDefault) != 0)
            readValue(in, type);
        if (!in.ok() || !value || (flags & ~kHasDefault) != 0)
            return std::nullopt;
        out.parameters.push_back({name, value->type, value->value});
    }
    if (!in.atEnd())
        return std::nullopt;
    return out;
}

} // namespace skyseal::mavlink
