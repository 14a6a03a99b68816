// The diagnostics' samples as a table for other programs: one line a sample, figures as they were measured, not as rounded
// for the eye; empty where nothing was known.
#pragma once

#include "core/engine/station/snapshot.h"

#include <QtCore/QByteArray>

#include <deque>

namespace skyseal::ui {

/// RFC 4180 with a header line; decimal points whatever the locale. Only samples with from <= time <= to (seconds).
QByteArray samplesCsv(const std::deque<engine::MetricsSample> &samples, double from, double to);

} // namespace skyseal::ui
