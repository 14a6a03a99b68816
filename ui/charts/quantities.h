// What the diagnostics can show: each quantity with its unit, its lines, and a sentence on how it is measured. One table for
// charts, bars, the comparison table and the CSV.
#pragma once

#include "core/engine/station/snapshot.h"
#include "core/metrics/energy_meter.h"
#include "ui/charts/chart.h"

#include <vector>

namespace skyseal::ui {

using SampleValue = double (*)(const engine::MetricsSample &);

struct QuantityLine
{
    QString name; ///< "to us"; empty where the quantity has one line
    Stroke stroke = Stroke::Solid;
    SampleValue value; ///< NaN where it is not known
};

struct Quantity
{
    const char *key; ///< for object names, settings and CSV
    QString title, unit, note;
    int decimals = 1;
    double least = 1; ///< the least end of its axis
    std::vector<QuantityLine> lines;
    bool perSuite = true;    ///< false: the figure says nothing about a suite, so that bars would mislead
    QString remark = {};     ///< in the chart: why there is nothing to see
    std::size_t barLine = 0; ///< of which line the bars are
};

/// All of them, in the order in which they are shown. `powercap`: where the kernel's energy counters are.
std::vector<Quantity> allQuantities(const std::string &powercap = metrics::EnergyMeter::kFolder);

/// A choice of quantities for the place that there is.
struct QuantityGroup
{
    QString title;
    std::vector<const char *> keys;
};

std::vector<QuantityGroup> quantityGroups();

} // namespace skyseal::ui
