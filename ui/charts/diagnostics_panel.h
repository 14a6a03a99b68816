// The diagnostics panel: throughput, losses and cost of the link over time or suite over suite, with bars that compare the
// suites. Samples are always collected; charts are drawn four times a second, and only while they are visible.
#pragma once

#include "ui/charts/axis_scale.h"
#include "ui/charts/chart_builder.h"
#include "ui/charts/session_memory.h"
#include "ui/dock_panel.h"
#include "ui/view_state.h"

#include <QtCore/QTimer>

#include <functional>

class QLabel;
class QStackedWidget;
class QTableView;

namespace skyseal::ui {

class ChartGrid;
class DiagnosticsTools;
class SuiteTableModel;
class SweepPage;

class DiagnosticsPanel : public DockPanel
{
    Q_OBJECT

public:
    static constexpr int kRefreshMs = 240;
    /// Charts that one refresh draws. If more are shown, they take turns, so that the cost is bounded.
    static constexpr std::size_t kChartsAtOnce = 6;
    static constexpr std::size_t kOverlaysAtOnce = 3; ///< an overlay has a line for every suite

    explicit DiagnosticsPanel(QWidget *parent = nullptr);
    void setSessionMeasure(const SessionMemory::Measure &measure) { m_sessionMemory = SessionMemory(measure); }
    ~DiagnosticsPanel() override;

    void onSnapshot(const ViewState &view) override;
    /// Draws all shown charts at once, without waiting for the next refresh.
    void refresh();
    SweepPage *sweep() const { return m_sweep; }
    /// Shows the page of the sweep instead of the charts.
    void showSweep();
    /// Returns one of the shown charts.
    TimeSeriesChart *chart(int index) const;
    int chartCount() const { return static_cast<int>(m_shown.size()); }
    const ChartRange &range() const { return m_range; }
    const SampleHistory &history() const { return m_history; }

    /// Write the shown samples or charts. Return the error text; empty on success.
    QString saveCsv(const QString &file) const;
    QString savePicture(const QString &file);

Q_SIGNALS:
    /// The page of the sweep was opened or left.
    void sweepShown(bool shown);

protected:
    void exposedChanged(bool seen) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    struct Plot
    {
        const Quantity *quantity;
        std::size_t firstTally;
        AxisScale scale;
        TimeSeriesChart *widget = nullptr; ///< made when it is first shown
    };

    void makePlots();
    void connectTools();
    TimeSeriesChart *widgetOf(Plot &plot);
    void showGroup();
    void showView();
    void showPage();
    void showWatching();
    std::size_t chartsAtOnce() const;
    void draw(std::size_t count);
    void drawPlot(Plot &plot, const std::vector<ChartMark> &marks);
    void changeRange(const std::function<void(ChartRange &)> &change);
    void showCursor(std::optional<double> x);
    void askAndSave(const QString &title, const QString &name, const QString &filter,
                    const std::function<QString(const QString &)> &save);

    std::vector<Quantity> m_quantities;
    SessionMemory m_sessionMemory;
    SampleHistory m_history;
    ChartRange m_range;
    std::vector<Plot> m_plots;
    std::vector<std::size_t> m_shown; ///< indices into m_plots
    DiagnosticsTools *m_tools;
    QStackedWidget *m_pages;
    QLabel *m_empty;    ///< until a vehicle is heard
    QLabel *m_watching; ///< what these measurements cost themselves, while the CPU load is shown
    ChartGrid *m_grid;
    QTableView *m_table;
    SweepPage *m_sweep;
    SuiteTableModel *m_model;
    bool m_hasLink = false; ///< a vehicle was heard
    QTimer *m_timer;        ///< runs only while the charts are visible
    std::size_t m_due = 0;  ///< charts that new samples have not been drawn in
    std::size_t m_next = 0; ///< index in m_shown of the chart drawn last
};

} // namespace skyseal::ui
