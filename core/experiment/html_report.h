// The report of a sweep in the form that a publication needs: figures, tables, significant differences, noise of the machine,
// claims of the paper, every sample, and the setting.
#pragma once

#include "core/experiment/claims.h"
#include "core/experiment/report_figures.h"
#include "core/experiment/results.h"
#include "core/experiment/verdicts.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

struct ReportParts
{
    const Results &results;
    const std::vector<ReportFigure> &figures;
    const std::vector<Verdict> &verdicts;
    const std::vector<Claim> &claims;
};

/// One self-contained page.
std::string htmlReport(const ReportParts &parts);
/// The same as rich text of Qt, for the PDF: figures are <img src="figures/NAME.svg">.
std::string printReport(const ReportParts &parts);

} // namespace skyseal::experiment
