#include "ui/charts/diagnostics_panel.h"

#include "ui/charts/suite_legend.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

using engine::MetricsSample;

DiagnosticsPanel::DiagnosticsPanel(QWidget *parent) : DockPanel(parent), m_timer(new QTimer(this))
{
    m_legend = new SuiteLegend(this);
    m_cost = new QLabel(this);
    m_cost->setObjectName(QStringLiteral("suiteCost"));
    m_cost->setAccessibleName(tr("Cost of the suite in use"));
    m_cost->setForegroundRole(QPalette::PlaceholderText);
    m_span = new QComboBox(this);
    m_span->setObjectName(QStringLiteral("chartSpan"));
    m_span->setAccessibleName(tr("Time shown"));
    for (const int seconds : {60, 120, 300, 600})
        m_span->addItem(seconds < 120 ? tr("%1 s").arg(seconds) : tr("%1 min").arg(seconds / 60), seconds);
    m_span->setCurrentIndex(1);
    m_freeze = new QCheckBox(tr("Freeze"), this);
    m_freeze->setObjectName(QStringLiteral("chartFreeze"));
    m_freeze->setAccessibleName(tr("Freeze the charts"));

    auto *tools = new QHBoxLayout;
    tools->setSpacing(kGrid);
    tools->addWidget(m_legend, 1);
    tools->addWidget(m_cost);
    tools->addWidget(m_span);
    tools->addWidget(m_freeze);
    auto *plots = new QHBoxLayout;
    plots->setSpacing(kGrid);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kHalfGrid, kGrid, kHalfGrid);
    column->setSpacing(kHalfGrid);
    column->addLayout(tools);
    column->addLayout(plots, 1);

    const auto up = [](double MetricsSample::*member) -> SampleValue {
        return [member](const MetricsSample &s) { return s.linkUp ? s.*member : vehicle::kUnknown; };
    };
    addPlot(QStringLiteral("chartRate"), tr("Decryption rate"), tr("frames/s"), 10,
            {{up(&MetricsSample::openedFramesPerSecond)}});
    addPlot(QStringLiteral("chartLoss"), tr("Packet loss"), tr("% (to it dotted)"), 1,
            {{up(&MetricsSample::lossPercent)}, {up(&MetricsSample::peerLossPercent), true}});
    addPlot(QStringLiteral("chartCpu"), tr("CPU load"), tr("% of a core (suite dotted)"), 5,
            {{[](const MetricsSample &s) { return s.processCpuPercent; }}, {up(&MetricsSample::suiteCpuPercent), true}});
    for (const Plot &plot : m_charts)
        plots->addWidget(plot.widget, 1);

    m_timer->setInterval(kRefreshMs);
    connect(m_timer, &QTimer::timeout, this, [this] {
        if (m_fresh && !m_freeze->isChecked())
            refresh();
    });
    connect(m_span, &QComboBox::currentIndexChanged, this, &DiagnosticsPanel::refresh);
}

void DiagnosticsPanel::addPlot(const QString &name, const QString &title, const QString &unit, double least,
                               std::vector<ChartLine> lines)
{
    TimeSeriesChart *chart = makeTimeSeriesChart(title, unit, this);
    chart->setObjectName(name);
    m_charts.push_back({chart, std::move(lines), AxisScale(least)});
}

void DiagnosticsPanel::showScene(const Scene &scene)
{
    if (scene.snapshot && m_history.take(scene.snapshot->samples))
        m_fresh = true;
}

void DiagnosticsPanel::refresh()
{
    m_fresh = false;
    const double span = m_span->currentData().toDouble();
    for (Plot &plot : m_charts) {
        ChartContent content
            = buildChart(m_history, plot.lines, span, static_cast<std::size_t>(qMax(64, plot.widget->width())));
        content.top = plot.scale.update(highestOf(content), m_history.empty() ? 0 : m_history.samples().back().time);
        plot.widget->showContent(content);
    }
    m_legend->setSuites(suitesIn(m_history, span));
    QString cost;
    if (!m_history.empty() && m_history.samples().back().openNsP50 > 0) {
        const MetricsSample &last = m_history.samples().back();
        cost = tr("open %1 ns, p99 %2 ns").arg(number(last.openNsP50, 0), number(last.openNsP99, 0));
    }
    if (m_cost->text() != cost)
        m_cost->setText(cost);
}

void DiagnosticsPanel::seenChanged(bool seen)
{
    if (!seen) {
        m_timer->stop();
        return;
    }
    refresh();
    m_timer->start();
}

} // namespace skyseal::ui
