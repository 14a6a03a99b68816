// The table of everything that the diagnostics measure. Charts, bars, the comparison table, the CSV file and the help page are
// all made from it, so a new quantity is one row in quantities.cpp.
#pragma once

#include "core/engine/station/metrics_sample.h"
#include "core/metrics/energy_meter.h"
#include "ui/charts/chart.h"

#include <vector>

namespace skyseal::ui {

inline constexpr double kGapSeconds = 2; ///< samples farther apart are not joined

/// A value of a sample, as the CSV file holds it and as a chart plots it.
struct SampleValue
{
    /// The samples in which a chart plots the value.
    enum class Valid : std::uint8_t {
        Always,
        LinkUp,   ///< nothing is measured without a vehicle
        Recorded, ///< the same, and 0 means that there was no record to measure
    };

    const char *column;                            ///< name of the CSV column, which ends with its unit
    double (*read)(const engine::MetricsSample &); ///< in the unit of the column; NaN if unknown
    double scale = 1;                              ///< from the unit of the column to the unit of the chart
    Valid valid = Valid::LinkUp;

    /// In the unit of the chart; NaN if there is nothing to plot.
    double operator()(const engine::MetricsSample &sample) const;
};

struct QuantityLine
{
    QString name; ///< "from vehicle"; empty if the quantity has one line
    Stroke stroke = Stroke::Solid;
    SampleValue value;
};

enum class QuantityGroupId : std::uint8_t { Rates, Link, Cost };

struct Quantity
{
    const char *key; ///< for object names
    QString title, unit;
    QString note; ///< how it is measured, for tool tips and the help page
    QuantityGroupId group;
    bool overview = false; ///< also in the group that is shown first
    int decimals = 1;
    double least = 1; ///< smallest end of the y axis
    std::vector<QuantityLine> lines;
    std::size_t barLine = 0;               ///< the line that the bars and their means are of
    bool perSuite = true;                  ///< false: independent of the suite, so that there are no bars
    std::vector<SampleValue> csvOnly = {}; ///< further columns of the CSV file, which no chart plots
    QString remark = {};                   ///< shown in the chart if there is nothing to plot
};

/// All quantities in the order in which they are shown. `sysfs`: see metrics::EnergyMeter.
std::vector<Quantity> allQuantities(const std::string &sysfs = metrics::EnergyMeter::kSysfs);

/// A selection of quantities for the charts.
struct QuantityGroup
{
    QString title;
    std::vector<const char *> keys;
};

/// Overview, one group per QuantityGroupId, and all.
std::vector<QuantityGroup> quantityGroups();

/// The part of the help page that says what each quantity is, in Markdown.
QString quantitiesHelp();

} // namespace skyseal::ui
