// Prints a recording as text, one message a line: JSON for scripts, plain text for people. Each damaged spot has its own line;
// reading continues behind it.
#pragma once

#include "core/base/secret_bytes_fwd.h"
#include "core/log/log_reader.h"

#include <functional>
#include <string_view>

namespace skyseal::tlog {

struct DecodeOptions
{
    bool json = false;
    LogFormat format = LogFormat::Auto;
    /// If set, signed frames with a signature of another key are reported as bad. Unsigned frames are not affected.
    const Key32 *signingKey = nullptr;
    /// If set, decrypts each frame before it is printed. The result must be valid until the next call.
    std::function<mavlink::Frame(const mavlink::Frame &)> open = {};
};

struct DecodeCounts
{
    std::uint64_t messages = 0;
    std::uint64_t bad = 0;
};

/// Reads `input` to its end and passes each line, without a line break, to `sink`. JSON lines have the form of
/// writeMessageJson() and writeBadJson(). Stops when `sink` returns false (for example, when a pipe was closed).
DecodeCounts decode(std::istream &input, const mavlink::Dialect &dialect, const DecodeOptions &options,
                    const std::function<bool(std::string_view line)> &sink);

} // namespace skyseal::tlog
