// The samples as a CSV table for other programs: one line per sample, values as measured, empty cells for unknown values. The
// columns come from the table of quantities.
#pragma once

#include "core/engine/station/metrics_sample.h"

#include <QtCore/QByteArray>

#include <deque>

namespace skyseal::ui {

/// RFC 4180 with a header line and decimal points in every locale. Contains the samples with from <= time <= to (seconds).
QByteArray samplesCsv(const std::deque<engine::MetricsSample> &samples, double from, double to);

} // namespace skyseal::ui
