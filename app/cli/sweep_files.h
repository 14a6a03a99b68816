// The files of a sweep: sweep.json, sweep.csv, report.html, figures as SVG; PNG and PDF where skyseal-figures is installed.
#pragma once

#include "core/experiment/results.h"
#include "core/experiment/verdicts.h"

#include <QtCore/QString>

#include <string>
#include <vector>

namespace skyseal::app {

struct SweepFiles
{
    bool written = false;
    std::string problem; ///< a sentence: why not, or what is missing; empty when all is there
};

SweepFiles writeSweepFiles(const QString &folder, const experiment::Results &results,
                           const std::vector<experiment::Verdict> &verdicts);

/// One of our programs: beside this one, then on the PATH; empty where it is missing.
QString programPath(const QString &name);

} // namespace skyseal::app
