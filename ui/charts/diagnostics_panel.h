// The diagnostics: what the link carries, loses and costs, over time or suite over suite, with bars to compare the suites
// by.
// Samples are kept all the time; charts are drawn four times a second (more than six in turns), and not at all while nobody
// sees them.
#pragma once

#include "ui/charts/axis_scale.h"
#include "ui/charts/chart_builder.h"
#include "ui/charts/session_memory.h"
#include "ui/dock_panel.h"
#include "ui/view_state.h"

#include <QtCore/QTimer>

#include <functional>

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
    /// Charts that one refresh draws. Where more are shown they take turns, so that looking at all of them costs no more.
    static constexpr std::size_t kChartsAtOnce = 6;
    static constexpr std::size_t kOverlaysAtOnce = 3; ///< each has a line for every suite, and most of it is history

    explicit DiagnosticsPanel(QWidget *parent = nullptr);
    void setSessionMeasure(const SessionMemory::Measure &measure) { m_sessionMemory = SessionMemory(measure); }
    ~DiagnosticsPanel() override;

    void onSnapshot(const ViewState &view) override;
    /// Draws what is known now, also where the next refresh is not due.
    void refresh();
    SweepPage *sweep() const { return m_sweep; }
    /// In place of the charts.
    void showSweep();
    /// Of the charts that are shown.
    TimeSeriesChart *chart(int index) const;
    int chartCount() const { return static_cast<int>(m_shown.size()); }
    const ChartRange &range() const { return m_range; }
    const SampleHistory &history() const { return m_history; }

    /// Empty when it was written, otherwise what went wrong. The samples are those of the time that is shown.
    QString saveCsv(const QString &file) const;
    QString savePicture(const QString &file);

protected:
    void exposedChanged(bool seen) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    struct Plot
    {
        const Quantity *quantity;
        std::size_t firstTally;
        AxisScale scale;
        TimeSeriesChart *widget = nullptr; ///< made when it is shown for the first time
    };

    void makePlots();
    void connectTools();
    TimeSeriesChart *widgetOf(Plot &plot);
    void showGroup();
    void showView();
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
    std::vector<std::size_t> m_shown; ///< places in m_plots
    DiagnosticsTools *m_tools;
    QStackedWidget *m_pages;
    ChartGrid *m_grid;
    QTableView *m_table;
    SweepPage *m_sweep;
    SuiteTableModel *m_model;
    QTimer *m_timer;        ///< runs only while the charts can be seen
    std::size_t m_due = 0;  ///< charts that show less than is known
    std::size_t m_next = 0; ///< whose turn it is, in m_shown
};

} // namespace skyseal::ui
