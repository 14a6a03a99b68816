// The files of a sweep: sweep.json, sweep.csv, report.html, figures as SVG; PNG and PDF where skyseal-figures is installed.
#pragma once

#include "core/experiment/heap_figures.h"
#include "core/experiment/results.h"
#include "core/experiment/verdicts.h"

#include <QtCore/QString>

#include <map>
#include <string>
#include <vector>

namespace skyseal::app {

struct SweepFiles
{
    bool written = false;
    std::string problem; ///< a sentence: why not, or what is missing; empty when all is there
};

/// The heap of one keyed cipher, in bytes, of those suites that it can be told of.
using ContextSizes = std::map<crypto::SuiteId, double>;
ContextSizes contextSizes(experiment::HeapFigures &heap);

/// Takes seconds where there are pictures to draw; any thread. Where the folder holds an older sweep, its figures and its
/// PDF are removed first; no other file is.
SweepFiles writeSweepFiles(const QString &folder, const experiment::Results &results,
                           const std::vector<experiment::Verdict> &verdicts, const ContextSizes &contexts);

/// One of our programs: beside this one, then on the PATH; empty where it is missing.
QString programPath(const QString &name);

} // namespace skyseal::app
