// A recording as a table: what a station would have known of each vehicle, a row at a steady pace, for spreadsheets and
// plots. The columns are those under which the monitor and flight scripts know the values.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/dialect.h"

#include <cstdint>
#include <functional>
#include <istream>
#include <string>

namespace skyseal::engine {

/// Reads all of `input` (a .tlog; raw bytes have no times and give no rows) and hands out a head line and then each row,
/// without their ends: "time" as seconds since 1970 first. The number of rows.
std::uint64_t exportTelemetry(std::istream &input, const mavlink::Dialect &dialect, Duration every,
                              const std::function<bool(const std::string &line)> &sink);

} // namespace skyseal::engine
