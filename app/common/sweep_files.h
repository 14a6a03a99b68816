// The files of a sweep: sweep.json, sweep.csv, ratios.csv, the columns of both, report.html, figures as SVG; PNG and PDF if
// skyseal-figures is installed.
#pragma once

#include "core/base/reason.h"
#include "core/experiment/heap_figures.h"
#include "core/experiment/pooled_report.h"
#include "core/experiment/results.h"
#include "core/experiment/verdicts.h"

#include <QtCore/QString>

#include <map>
#include <vector>

namespace skyseal::app {

struct SweepFiles
{
    bool written = false;
    Reason problem; ///< the error or the missing files; empty if complete
};

/// Heap bytes of one keyed cipher, for each suite where they can be measured: Results::contextBytes.
std::map<crypto::SuiteId, double> contextSizes(experiment::HeapFigures &heap);

/// Takes seconds if there are pictures to draw; thread-safe. Removes figures and PDF of an older sweep in the folder first, but
/// no other file.
SweepFiles writeSweepFiles(const QString &folder, const experiment::Results &results,
                           const std::vector<experiment::Verdict> &verdicts);

/// One analysis of several sweeps: report.html, pooled.csv and the forest plots as SVG. Replaces files of the same names.
SweepFiles writePooledFiles(const QString &folder, const std::vector<experiment::Machine> &machines);

/// The path of a program of Skyseal: in the folder of this program, then on the PATH; empty if missing.
QString programPath(const QString &name);

} // namespace skyseal::app
