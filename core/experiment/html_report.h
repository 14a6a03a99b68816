// A sweep as a report that can stand beside a publication: figures, tables, what differs and what does not, the machine's
// noise, the paper's claims, every raw sample, and with what all of it was measured.
#pragma once

#include "core/experiment/claims.h"
#include "core/experiment/results.h"
#include "core/experiment/verdicts.h"

#include <string>
#include <vector>

namespace skyseal::experiment {

struct Figure
{
    std::string name; ///< of its files, without extension: "packets-natural"
    std::string svg;
};

/// The paper's three (packets, memory, CPU), then rate, latency, overhead and what a record costs; for every condition and
/// load, without those that nothing was measured of.
std::vector<Figure> figuresOf(const Results &results);

struct ReportParts
{
    const Results &results;
    const std::vector<Figure> &figures;
    const std::vector<Verdict> &verdicts;
    const std::vector<Claim> &claims;
};

/// One self-contained page.
std::string htmlReport(const ReportParts &parts);
/// The same for Qt's rich text, from which the PDF is made: figures are <img src="figures/NAME.svg">.
std::string printReport(const ReportParts &parts);

} // namespace skyseal::experiment
