// A snapshot of a station in the OpenMetrics text format, for Prometheus and others.
// https://github.com/prometheus/OpenMetrics/blob/main/specification/OpenMetrics.md
#pragma once

#include <string>

namespace skyseal::engine {

struct Snapshot;

/// The Content-Type of the text.
inline constexpr const char *kOpenMetricsType = "application/openmetrics-text; version=1.0.0; charset=utf-8";

/// The whole exposition, with its end mark. Unknown quantities are omitted.
std::string openMetrics(const Snapshot &snapshot);

} // namespace skyseal::engine
