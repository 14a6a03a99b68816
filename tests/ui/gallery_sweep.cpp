#include "gallery_sweep.h"

#include "core/experiment/load_check.h"
#include "core/experiment/measured_link.h"
#include "core/experiment/setting.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/sweep/sweep_page.h"

#include <QtWidgets/QDockWidget>

namespace skyseal::ui {

using crypto::SuiteId;
using experiment::Metric;

namespace {

/// Each suite costs a twentieth more than the one before.
experiment::Sample sampleOf(const experiment::Run &run, unsigned order)
{
    experiment::Sample out;
    out.run = run;
    out.order = order;
    const double noise = (1 + 0.2 * run.repeat) * (1 + 0.004 * ((run.repeat * 2 + static_cast<unsigned>(run.arm)) % 3));
    const double cost = (1 + 0.05 * static_cast<double>(run.arm)) * noise;
    out.values[Metric::CpuPerFrame] = 11'000 * cost;
    out.values[Metric::AgentCpuPerFrame] = 9'400 * cost;
    out.values[Metric::Cpu] = 2.1 * cost;
    out.values[Metric::Latency] = 1.2 * noise;
    out.values[Metric::WirePerFrame] = 62 + 7.0 * static_cast<double>(run.arm);
    out.values[Metric::Packets] = 500 + order % 3;
    out.values[Metric::FrameRate] = 100 + 0.2 * (order % 3);
    out.values[Metric::Loss] = 0;
    out.values[Metric::MeterCpu] = 0.4;
    return out;
}

} // namespace

void showGallerySweep(MainWindow &window)
{
    auto results = std::make_shared<experiment::Results>();
    results->plan.arms = experiment::armsOf(
        {SuiteId::None, SuiteId::Aes256Gcm, SuiteId::ChaCha20Poly1305, SuiteId::Aes256Ctr, SuiteId::Rc4},
        {experiment::ArmFraming::Sealed, experiment::ArmFraming::Inline}, true);
    results->plan.loads = {experiment::Load::Natural, experiment::Load::Saturated};
    results->plan.repeats = 5;
    results->setting = {{"build_flags", "-O1"}, {"cores", "2"}, {"load_average_at_start", "8.57 4.2 3.1 2/345 678"}};
    results->setting.emplace_back(
        "warning", "this build is " + experiment::buildWarning("-O1").text() + "; " + experiment::busyWarning(8.57, 2).text());
    for (const experiment::Run &run : experiment::schedule(results->plan))
        results->samples.push_back(sampleOf(run, static_cast<unsigned>(results->samples.size())));
    results->samples[1].values[Metric::OtherCpu] = 35;
    results->samples[2].problem = experiment::MeasuredLink::kUnreadable;
    results->samples[3].values[Metric::Cpu] = 41;
    results->samples[3].invalid = experiment::loadProblem(experiment::Load::Saturated, results->samples[3].values);
    results->complete = true;
    results->seconds = 412;
    auto *diagnostics = window.findChild<DiagnosticsPanel *>();
    diagnostics->sweep()->begin(results->plan);
    diagnostics->sweep()->finish(results, {});
    auto *dock = window.findChild<QDockWidget *>(QStringLiteral("dockDiagnostics"));
    dock->raise();
    diagnostics->showSweep();
    window.resizeDocks({dock}, {window.height() / 2}, Qt::Vertical);
}

} // namespace skyseal::ui
