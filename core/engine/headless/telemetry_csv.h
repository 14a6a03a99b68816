// Exports a recording as a table for spreadsheets and plots: the state of each vehicle, one row per period. The columns have
// the names that the monitor and flight scripts use.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/dialect.h"

#include <cstdint>
#include <functional>
#include <istream>
#include <string>

namespace skyseal::engine {

/// Reads all of `input` (a .tlog; raw bytes have no timestamps and give no rows) and passes a header line and then each row,
/// without line ends; the first column is "time" in seconds since 1970, as recorded: it steps where the clock was set. `every`:
/// the least time between two rows of a vehicle. Returns the number of rows.
std::uint64_t exportTelemetry(std::istream &input, const mavlink::Dialect &dialect, Duration every,
                              const std::function<bool(const std::string &line)> &sink);

} // namespace skyseal::engine
