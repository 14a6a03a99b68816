#include "core/sim/packed_parameters.h"

#include "core/mavlink/packed_parameters.h"

#include <algorithm>
#include <bit>
#include <charconv>

namespace skyseal::sim {

namespace {

using mavlink::PackedType;

PackedType packedType(ParameterType type)
{
    switch (type) {
    case ParameterType::Int8: return mavlink::kPackedInt8;
    case ParameterType::Int16: return mavlink::kPackedInt16;
    case ParameterType::Int32: return mavlink::kPackedInt32;
    default: return mavlink::kPackedFloat;
    }
}

void append(Bytes &out, std::uint32_t value, std::size_t size)
{
    for (std::size_t i = 0; i < size; ++i)
        out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void appendValue(Bytes &out, PackedType type, float value)
{
    if (type == mavlink::kPackedFloat)
        append(out, std::bit_cast<std::uint32_t>(value), 4);
    else
        append(out, static_cast<std::uint32_t>(static_cast<std::int32_t>(value)), std::size_t(1) << (type - 1));
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
    append(out, selection.defaults ? mavlink::kPackedMagicWithDefaults : mavlink::kPackedMagic, 2);
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
    const auto unpacked = mavlink::parsePackedParameters(file);
    if (!unpacked || unpacked->hasDefaults || unpacked->total != file.size())
        return false;
    for (const mavlink::PackedParameter &parameter : unpacked->parameters) {
        if (const auto index = parameters.find(parameter.name))
            parameters.set(*index, static_cast<float>(parameter.value));
    }
    return true;
}

} // namespace skyseal::sim
