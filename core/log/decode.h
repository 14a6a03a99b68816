// A recording as text, one message a line: JSON for scripts, or words for people. What is damaged gets a line of its own,
// and what follows it is not lost.
#pragma once

#include "core/base/secret_bytes.h"
#include "core/log/log_reader.h"

#include <functional>
#include <string_view>

namespace skyseal::tlog {

struct DecodeOptions
{
    bool json = false;
    LogFormat format = LogFormat::Auto;
    /// When given, signed frames whose signature was not made with this key are bad; unsigned ones stay as they are.
    const Key32 *signingKey = nullptr;
    /// When given, what each frame is shown as: for streams whose payloads are encrypted. The result lives until the next
    /// call.
    std::function<mavlink::Frame(const mavlink::Frame &)> open = {};
};

struct DecodeCounts
{
    std::uint64_t messages = 0;
    std::uint64_t bad = 0;
};

/// Reads all of `input` and hands out each line without its end. The lines of JSON are those of writeMessageJson and
/// writeBadJson. A sink that returns false ends it (the reader of a pipe has gone).
DecodeCounts decode(std::istream &input, const mavlink::Dialect &dialect, const DecodeOptions &options,
                    const std::function<bool(std::string_view line)> &sink);

} // namespace skyseal::tlog
