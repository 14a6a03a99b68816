// One analysis of several sweeps of one setting on several machines: for each ratio the machines beside each other and, from
// three on, what they have in common. Launches and seeds are nested in the machine: each machine's interval comes from its own
// sweep.
#pragma once

#include "core/experiment/report_figures.h"
#include "core/experiment/results.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

struct Machine
{
    std::string label; ///< the folder's name
    unsigned schemaVersion = 0;
    Results results;
};

/// A sentence, if the sweeps are not of one setting: schema, framings, loads, conditions, length of the runs, vehicle and its
/// messages, commit. Empty if they are.
std::string mismatchOf(const std::vector<Machine> &machines);

/// One forest plot for each metric with kRatio, condition, load and arm that at least two machines compared with the reference.
std::vector<ReportFigure> forestsOf(const std::vector<Machine> &machines);
std::string pooledCsv(const std::vector<Machine> &machines);
/// One self-contained page. It repeats the warnings of each sweep.
std::string pooledHtml(const std::vector<Machine> &machines);
/// The same as rich text of Qt, for the PDF: figures are <img src="figures/NAME.svg">.
std::string pooledPrint(const std::vector<Machine> &machines);

} // namespace skyseal::experiment
