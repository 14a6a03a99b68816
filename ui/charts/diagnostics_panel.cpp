#include "ui/charts/diagnostics_panel.h"

#include "core/engine/station/snapshot.h"
#include "ui/ask_file.h"
#include "ui/charts/chart_export.h"
#include "ui/charts/chart_grid.h"
#include "ui/charts/diagnostics_tools.h"
#include "ui/charts/samples_csv.h"
#include "ui/charts/suite_legend.h"
#include "ui/charts/suite_table_model.h"
#include "ui/modeless.h"
#include "ui/sweep/sweep_page.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QKeyEvent>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QTableView>
#include <QtWidgets/QVBoxLayout>

#include <algorithm>
#include <cstring>

namespace skyseal::ui {

DiagnosticsPanel::DiagnosticsPanel(QWidget *parent)
    : DockPanel(parent), m_quantities(allQuantities()), m_history(m_quantities), m_tools(new DiagnosticsTools(this)),
      m_pages(new QStackedWidget(this)), m_empty(new QLabel(m_pages)), m_watching(new QLabel(this)),
      m_grid(new ChartGrid(m_pages)), m_table(new QTableView(m_pages)), m_sweep(new SweepPage(m_pages)),
      m_model(new SuiteTableModel(m_history, m_quantities, this)), m_timer(new QTimer(this))
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Charts of the diagnostics"));
    m_table->setModel(m_model);
    m_table->setObjectName(QStringLiteral("suiteTable"));
    m_table->setAccessibleName(tr("Suites compared"));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(kRow);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_empty->setText(tr("Connect to a vehicle to see the throughput, losses, latency and cost of its link."));
    m_empty->setObjectName(QStringLiteral("chartsEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_grid);
    m_pages->addWidget(m_table);
    m_pages->addWidget(m_sweep);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kHalfGrid, kGrid, kHalfGrid);
    column->setSpacing(kHalfGrid);
    column->addWidget(m_tools);
    column->addWidget(m_pages, 1);
    column->addWidget(m_watching);
    m_watching->setObjectName(QStringLiteral("watchingCost"));
    m_watching->setAccessibleName(tr("Cost of watching"));
    m_watching->setForegroundRole(QPalette::PlaceholderText);
    m_watching->setMinimumWidth(10 * kGrid);
    m_watching->setToolTip(
        tr("CPU time of the link thread for the snapshots that this window shows and for these measurements, "
           "over the last second. The lines “link” and “process” contain it. A sweep measures without "
           "them, or states their share."));
    makePlots();
    connectTools();
    showGroup();
    m_tools->showRange(m_range);
    addActions(m_tools->actions());
    addActions(m_sweep->actions());
    showPage();

    m_timer->setInterval(kRefreshMs);
    connect(m_timer, &QTimer::timeout, this, [this] {
        if (m_due > 0 && !m_range.frozen())
            draw(std::min(m_due, chartsAtOnce()));
    });
}

DiagnosticsPanel::~DiagnosticsPanel()
{
    delete m_pages; // before the members: the table in it reads the history
}

void DiagnosticsPanel::makePlots()
{
    std::size_t tally = 0;
    for (const Quantity &quantity : m_quantities) {
        m_plots.push_back({&quantity, tally, AxisScale(quantity.least)});
        tally += quantity.lines.size();
    }
}

void DiagnosticsPanel::connectTools()
{
    connect(m_tools, &DiagnosticsTools::viewChanged, this, &DiagnosticsPanel::showView);
    connect(m_tools, &DiagnosticsTools::groupChanged, this, &DiagnosticsPanel::showGroup);
    connect(m_tools, &DiagnosticsTools::spanChosen, this,
            [this](double span) { changeRange([span](ChartRange &range) { range.setSpan(span); }); });
    connect(m_tools, &DiagnosticsTools::spanStepped, this,
            [this](int steps) { changeRange([steps](ChartRange &range) { range.zoom(steps); }); });
    connect(m_tools, &DiagnosticsTools::freezeChosen, this, [this](bool frozen) {
        changeRange([&](ChartRange &range) { frozen ? range.freeze(m_history.newest()) : range.goLive(); });
    });
    connect(m_tools, &DiagnosticsTools::csvRequested, this, [this] {
        askAndSave(tr("Save the samples shown"), QStringLiteral("skyseal-samples.csv"), tr("Comma-separated values (*.csv)"),
                   [this](const QString &file) { return saveCsv(file); });
    });
    connect(m_tools, &DiagnosticsTools::pictureRequested, this, [this] {
        askAndSave(tr("Save the picture"), QStringLiteral("skyseal-diagnostics.png"), tr("Pictures (*.png *.svg)"),
                   [this](const QString &file) { return savePicture(file); });
    });
}

TimeSeriesChart *DiagnosticsPanel::widgetOf(Plot &plot)
{
    if (plot.widget)
        return plot.widget;
    const Quantity &quantity = *plot.quantity;
    QStringList key;
    QString note = quantity.note;
    for (const QuantityLine &line : quantity.lines) {
        if (line.stroke == Stroke::Solid && !line.name.isEmpty() && quantity.lines.size() > 1)
            note += QLatin1Char(' ') + tr("The solid line is “%1”.").arg(line.name); // short, because titles are elided
        else if (line.stroke == Stroke::Dashed)
            key << tr("%1 dashed").arg(line.name);
        else if (line.stroke == Stroke::Dotted)
            key << tr("%1 dotted").arg(line.name);
        if (quantity.barLine > 0 && &line == &quantity.lines[quantity.barLine]) {
            key.back() = tr("%1 + bars").arg(key.back());
            note += QLatin1Char(' ') + tr("The bars show only “%1”.").arg(line.name);
        }
    }
    plot.widget = makeTimeSeriesChart({quantity.title, quantity.unit, key.join(QStringLiteral(", ")), note, quantity.remark},
                                      m_grid->sheet());
    plot.widget->setObjectName(QStringLiteral("chart_") + QLatin1String(quantity.key));
    connect(plot.widget, &TimeSeriesChart::hovered, this, [this](double x) { showCursor(x); });
    connect(plot.widget, &TimeSeriesChart::hoverEnded, this, [this] { showCursor({}); });
    connect(plot.widget, &TimeSeriesChart::zoomRequested, this,
            [this](int steps) { changeRange([steps](ChartRange &range) { range.zoom(steps); }); });
    connect(plot.widget, &TimeSeriesChart::rangeRequested, this, [this](double from, double to) {
        changeRange([&](ChartRange &range) { range.select(from, to, m_history.newest()); });
    });
    connect(plot.widget, &TimeSeriesChart::liveRequested, this,
            [this] { changeRange([](ChartRange &range) { range.goLive(); }); });
    return plot.widget;
}

void DiagnosticsPanel::showGroup()
{
    m_shown.clear();
    std::vector<QWidget *> widgets;
    for (const char *key : m_tools->group().keys) {
        const auto plot = std::ranges::find_if(m_plots, [key](const Plot &p) { return !std::strcmp(p.quantity->key, key); });
        m_shown.push_back(static_cast<std::size_t>(plot - m_plots.begin()));
        widgets.push_back(widgetOf(*plot));
    }
    m_grid->setCharts(widgets);
    showWatching();
    refresh();
}

void DiagnosticsPanel::showView()
{
    const bool sweepBefore = m_pages->currentWidget() == m_sweep;
    showPage();
    for (Plot &plot : m_plots)
        plot.scale = AxisScale(plot.quantity->least);
    showCursor({});
    refresh();
    if (const bool sweep = m_pages->currentWidget() == m_sweep; sweep != sweepBefore)
        Q_EMIT sweepShown(sweep);
}

void DiagnosticsPanel::showPage()
{
    if (m_tools->view() == DiagnosticsView::Sweep)
        m_pages->setCurrentWidget(m_sweep);
    else if (!m_hasLink)
        m_pages->setCurrentWidget(m_empty);
    else
        m_pages->setCurrentWidget(m_tools->view() == DiagnosticsView::Table ? static_cast<QWidget *>(m_table) : m_grid);
    showWatching();
}

/// In words, because a line of it would lie on the axis.
void DiagnosticsPanel::showWatching()
{
    const bool isShown = m_pages->currentWidget() == m_grid && !m_history.empty()
        && std::ranges::any_of(m_tools->group().keys, [](const char *key) { return std::strcmp(key, "cpu") == 0; });
    m_watching->setVisible(isShown);
    if (!isShown)
        return;
    const engine::MetricsSample &newest = m_history.samples().back();
    m_watching->setText(tr("CPU of the link thread: %1 % of a core, of it watching: %2 %")
                            .arg(number(newest.ioCpuPercent, 2), number(newest.watchingCpuPercent, 2)));
}

void DiagnosticsPanel::showSweep()
{
    m_tools->setView(DiagnosticsView::Sweep);
}

TimeSeriesChart *DiagnosticsPanel::chart(int index) const
{
    return m_plots[m_shown[static_cast<std::size_t>(index)]].widget;
}

void DiagnosticsPanel::onSnapshot(const ViewState &view)
{
    const SnapshotPtr &station = view.station(); // the charts measure the live link, also while a replay is shown
    if (!station || station->samples.empty())
        return;
    // Snapshots are more frequent than samples.
    if (!m_history.empty() && m_history.samples().back().number == station->samples.back().number)
        return;
    std::vector<engine::MetricsSample> samples = station->samples;
    for (engine::MetricsSample &sample : samples)
        sample.sessionBytes = m_sessionMemory.of(sample.suite);
    if (!m_history.take(samples))
        return;
    m_due = m_shown.size();
    if (const bool has = m_history.hasLink(); has != m_hasLink) {
        m_hasLink = has;
        showPage();
        if (isVisible())
            refresh();
    }
}

void DiagnosticsPanel::refresh()
{
    draw(m_shown.size());
}

std::size_t DiagnosticsPanel::chartsAtOnce() const
{
    return m_tools->view() == DiagnosticsView::Overlay ? kOverlaysAtOnce : kChartsAtOnce;
}

/// Draws the `count` charts that were drawn longest ago, or the whole table.
void DiagnosticsPanel::draw(std::size_t count)
{
    m_due = m_tools->view() == DiagnosticsView::Table ? 0 : m_due - std::min(m_due, count);
    m_tools->legend()->setSuites(suitesUsed(m_history));
    if (m_tools->view() == DiagnosticsView::Sweep)
        return;
    if (m_tools->view() == DiagnosticsView::Table) {
        m_model->refresh();
        return;
    }
    const StateColors &colors = stateColors(palette());
    const std::vector<ChartMark> marks = m_tools->view() == DiagnosticsView::TimeLine
        ? buildMarks(m_history, m_range, colors.alarm, colors.dim)
        : std::vector<ChartMark>();
    if (!m_range.frozen())
        showWatching();
    for (std::size_t i = 0; i < count; ++i) {
        m_next = (m_next + 1) % m_shown.size();
        drawPlot(m_plots[m_shown[m_next]], marks);
    }
}

void DiagnosticsPanel::drawPlot(Plot &plot, const std::vector<ChartMark> &marks)
{
    const auto most = static_cast<std::size_t>(std::max(64, plot.widget->width()));
    ChartContent content = m_tools->view() == DiagnosticsView::Overlay
        ? buildOverlay(m_history, *plot.quantity, m_range, most)
        : buildTimeLine(m_history, *plot.quantity, m_range, most);
    content.marks = marks;
    content.bars = buildBars(m_history, *plot.quantity, plot.firstTally);
    content.top = plot.scale.update(highestOf(content), m_history.newest());
    plot.widget->showContent(content);
}

void DiagnosticsPanel::changeRange(const std::function<void(ChartRange &)> &change)
{
    change(m_range);
    m_tools->showRange(m_range);
    refresh();
}

void DiagnosticsPanel::showCursor(std::optional<double> x)
{
    for (const std::size_t place : m_shown)
        m_plots[place].widget->showCursor(x);
}

void DiagnosticsPanel::keyPressEvent(QKeyEvent *event)
{
    constexpr double kPan = 0.25;
    const double newest = m_history.newest();
    switch (event->key()) {
    case Qt::Key_Plus: changeRange([](ChartRange &range) { range.zoom(1); }); break;
    case Qt::Key_Minus: changeRange([](ChartRange &range) { range.zoom(-1); }); break;
    case Qt::Key_Left: changeRange([&](ChartRange &range) { range.pan(-kPan, newest); }); break;
    case Qt::Key_Right: changeRange([&](ChartRange &range) { range.pan(kPan, newest); }); break;
    case Qt::Key_Space: changeRange([&](ChartRange &range) { range.frozen() ? range.goLive() : range.freeze(newest); }); break;
    case Qt::Key_Home:
    case Qt::Key_Escape: changeRange([](ChartRange &range) { range.goLive(); }); break;
    default: DockPanel::keyPressEvent(event);
    }
}

QString DiagnosticsPanel::saveCsv(const QString &file) const
{
    const double zero = m_range.zero(m_history.newest());
    return writeWhole(file, samplesCsv(m_history.samples(), zero + m_range.from(), zero + m_range.to()));
}

QString DiagnosticsPanel::savePicture(const QString &file)
{
    QWidget *charts = m_tools->view() == DiagnosticsView::Table ? static_cast<QWidget *>(m_table) : m_grid->sheet();
    return writePicture(file, {m_tools->legend(), charts});
}

void DiagnosticsPanel::askAndSave(const QString &title, const QString &name, const QString &filter,
                                  const std::function<QString(const QString &)> &save)
{
    const auto write = [this, title, save](const QString &file) {
        const QString problem = save(file);
        if (problem.isEmpty())
            return;
        auto *box = new QMessageBox(QMessageBox::Warning, title, problem, QMessageBox::Ok, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->setTextFormat(Qt::PlainText); // with the name of the file
        showModeless(*box);
    };
    askFile(*this, {.title = title, .kinds = filter, .start = name, .use = FileQuestion::Use::Write}, write);
}

void DiagnosticsPanel::exposedChanged(bool seen)
{
    if (!seen) {
        m_timer->stop();
        return;
    }
    refresh();
    m_timer->start();
}

} // namespace skyseal::ui

#include "moc_diagnostics_panel.cpp"
