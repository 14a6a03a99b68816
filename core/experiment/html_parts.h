// Parts that the tables of a report share. Pure functions.
#pragma once

#include "core/experiment/plan.h"
#include "core/experiment/report_figures.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

/// A row of a table. `cells` are HTML.
std::string row(const std::vector<std::string> &cells);

/// The rows of a table's head, which pages repeat.
std::string headOfTable(const std::vector<std::vector<std::string>> &rows);

/// <img src="figures/NAME.svg">, two side by side, for a PDF.
std::string figuresInPairs(const std::vector<ReportFigure> &figures);

/// The name of an arm, marked if it is insecure.
std::string armText(const SweepArm &arm);

} // namespace skyseal::experiment
