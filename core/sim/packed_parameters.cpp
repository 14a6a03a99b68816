#include "core/sim/packed_parameters.h"

#include "core/base/byte_reader.h"

#include <algorithm>
#include <bit>
#include <charconv>

namespace skyseal::sim {

namespace {

constexpr std::uint16_t kMagic = 0x671b, kMagicWithDefaults = 0x671c;
constexpr std::size_t kLongestName = 16;

/// Of ArduPilot's AP_Param, not of MAVLink.
enum PackedType : std::uint8_t { kInt8 = 1, kInt16 = 2, kInt32 = 3, kFloat = 4 };

PackedType packedType(ParameterType type)
{
    switch (type) {
    case ParameterType::Int8: return kInt8;
    case ParameterType::Int16: return kInt16;
    case ParameterType::Int32: return kInt32;
    default: return kFloat;
    }
}

void append(Bytes &out, std::uint32_t value, std::size_t size)
{
    for (std::size_t i = 0; i < size; ++i)
        out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void appendValue(Bytes &out, PackedType type, float value)
{
    if (type == kFloat)
        append(out, std::bit_cast<std::uint32_t>(value), 4);
    else
        append(out, static_cast<std::uint32_t>(static_cast<std::int32_t>(value)), std::size_t(1) << (type - 1));
}

std::optional<float> readValue(ByteReader &in, std::uint8_t type)
{
    switch (type) {
    case kInt8: return in.littleEndian<std::int8_t>();
    case kInt16: return in.littleEndian<std::int16_t>();
    case kInt32: return static_cast<float>(in.littleEndian<std::int32_t>());
    case kFloat: return std::bit_cast<float>(in.u32());
    default: return std::nullopt;
    }
}

} // namespace

std::optional<PackedSelection> packedSelection(std::string_view query)
{
    PackedSelection out;
    while (!query.empty()) {
        const std::string_view part = query.substr(0, query.find('&'));
        query.remove_prefix(std::min(part.size() + 1, query.size()));
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos)
            continue;
        const std::string_view name = part.substr(0, equals), text = part.substr(equals + 1);
        std::uint16_t number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || end != text.data() + text.size())
            return std::nullopt;
        if (name == "start")
            out.start = number;
        else if (name == "count")
            out.count = number;
        else if (name == "withdefaults")
            out.defaults = number == 1;
    }
    return out;
}

Bytes packParameters(const Parameters &parameters, const PackedSelection &selection)
{
    const std::size_t total = parameters.count(), start = selection.start;
    if (start >= total)
        return {};
    const std::size_t count = selection.count == 0 ? total - start : std::min<std::size_t>(selection.count, total - start);
    Bytes out;
    out.reserve(6 + count * 16);
    append(out, selection.defaults ? kMagicWithDefaults : kMagic, 2);
    append(out, static_cast<std::uint32_t>(count), 2);
    append(out, static_cast<std::uint32_t>(total), 2);
    std::string_view last;
    for (std::size_t i = start; i < start + count; ++i) {
        const ParameterInfo &info = parameters.info(i);
        const std::string_view name = info.name;
        const auto common = static_cast<std::size_t>(std::mismatch(name.begin(), name.end(), last.begin(), last.end()).first
                                                     - name.begin());
        const std::size_t shared = std::min({common, name.size() - 1, std::size_t(15)}); // one character is always written
        const PackedType type = packedType(info.type);
        const bool withDefault = selection.defaults && parameters.value(i) != info.standard;
        out.push_back(static_cast<std::uint8_t>(type | (withDefault ? 0x10 : 0)));
        out.push_back(static_cast<std::uint8_t>(shared | (name.size() - shared - 1) << 4));
        out.insert(out.end(), name.begin() + static_cast<std::ptrdiff_t>(shared), name.end());
        appendValue(out, type, parameters.value(i));
        if (withDefault)
            appendValue(out, type, info.standard);
        last = name;
    }
    return out;
}

bool unpackParameters(ByteView file, Parameters &parameters)
{
    ByteReader in(file);
    const std::uint16_t magic = in.u16(), count = in.u16(), length = in.u16();
    if (!in.ok() || magic != kMagic || length != file.size())
        return false;
    std::vector<std::pair<std::size_t, float>> values;
    std::string name;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint8_t type = in.u8();
        while (type == 0 && in.ok() && !in.atEnd()) // padding
            type = in.u8();
        const std::uint8_t lengths = in.u8();
        const std::size_t shared = lengths & 0xf, added = (lengths >> 4) + 1u;
        if (shared > name.size() || shared + added > kLongestName)
            return false;
        name.resize(shared);
        name += asText(in.bytes(added));
        const auto value = readValue(in, type);
        if (!in.ok() || !value)
            return false;
        if (const auto index = parameters.find(name))
            values.emplace_back(*index, *value);
    }
    if (!in.atEnd())
        return false;
    for (const auto &[index, value] : values)
        parameters.set(index, value);
    return true;
}

} // namespace skyseal::sim
