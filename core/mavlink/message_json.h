// One message as one line of JSON, for scripts. The conversion is lossless: the payload can be rebuilt from the text.
#pragma once

#include "core/base/clock.h"
#include "core/base/json_writer.h"
#include "core/mavlink/frame.h"

#include <optional>

namespace skyseal::mavlink {

/// Writes {"event":"message","id","name","version","sysid","compid","seq","signed","fields":{…}}; with `time` also
/// "time_usec" (microseconds since 1970, a string). In "fields", in the order of the definition:
/// - integers are numbers, 64-bit ones strings, arrays arrays;
/// - floats are the shortest numbers that read back to the same bits, and "NaN", "Infinity", "-Infinity". A NaN other than
///   the usual one (0x7fc00000, 0x7ff8000000000000) is also written in a further member of the event,
///   "nan_bits":{"field":{"index":"hex"}};
/// - char arrays are strings without the zeros at their end. Invalid UTF-8 shows as U+FFFD, and the bytes of such a
///   field are also written in a further member of the event, "text_bytes":{"field":"hex"};
/// - fields that a MAVLink 1 frame does not carry (extensions) are left out.
void writeMessageJson(JsonWriter &json, const Frame &frame, std::optional<WallTime> time = std::nullopt);

/// Writes {"event":"bad","reason","offset","length"}: `length` bytes that are not a valid message.
void writeBadJson(JsonWriter &json, FrameFault fault, std::uint64_t offset, std::uint64_t length);

} // namespace skyseal::mavlink
