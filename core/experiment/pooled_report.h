// One analysis of several sweeps of one setting on several machines: for each ratio the sweeps beside each other and, from
// three machines on, what they have in common. Launches and seeds are nested in the sweep, whose interval comes from its own
// launches, and the sweeps of one machine, days, in the machine.
#pragma once

#include "core/experiment/report_figures.h"
#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

/// One sweep of a machine.
struct Machine
{
    std::string label; ///< the folder's name, distinct
    unsigned schemaVersion = 0;
    Results results;
};

/// A sentence, if the sweeps are not of one setting (schema, framings, loads, conditions, length of the runs, vehicle and its
/// messages, commit), if they are not known to be of the same programs, or if one is a copy of another. Empty otherwise.
std::string mismatchOf(const std::vector<Machine> &machines);

/// Processor, cores, memory and vehicle, by which sweeps of one machine are recognised; empty if not recorded.
std::string hardwareOf(const Machine &machine);
/// The sweeps of each machine, as indices. Two machines of the same hardware are taken for one.
std::vector<std::vector<std::size_t>> daysOfMachines(const std::vector<Machine> &machines);

/// One forest plot for each metric with kRatio, condition, load and arm that at least two sweeps compared with the reference.
std::vector<ReportFigure> forestsOf(const std::vector<Machine> &machines);
std::string pooledCsv(const std::vector<Machine> &machines);
/// The data dictionary of pooledCsv().
std::string pooledColumnsCsv();
/// One self-contained page. It repeats the warnings of each sweep.
std::string pooledHtml(const std::vector<Machine> &machines);
/// The same as rich text of Qt, for the PDF: figures are <img src="figures/NAME.svg">.
std::string pooledPrint(const std::vector<Machine> &machines);

} // namespace skyseal::experiment
