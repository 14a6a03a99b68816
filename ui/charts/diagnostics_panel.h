// The diagnostics: decryption rate, packet loss and CPU load over time, coloured by the suite that was in use. Samples are
// kept all the time; charts are drawn four times a second, and not at all while nobody sees them.
#pragma once

#include "ui/charts/axis_scale.h"
#include "ui/charts/chart_builder.h"
#include "ui/charts/sample_history.h"
#include "ui/dock_panel.h"
#include "ui/scene.h"

#include <QtCore/QTimer>
class QCheckBox;
class QComboBox;
class QLabel;

namespace skyseal::ui {

class SuiteLegend;

class DiagnosticsPanel : public DockPanel
{
    Q_OBJECT

public:
    static constexpr int kRefreshMs = 240;

    explicit DiagnosticsPanel(QWidget *parent = nullptr);

    void showScene(const Scene &scene);
    /// Draws what is known now, also where the next refresh is not due.
    void refresh();
    TimeSeriesChart *chart(int index) const { return m_charts[static_cast<std::size_t>(index)].widget; }

protected:
    void seenChanged(bool seen) override;

private:
    struct Plot
    {
        TimeSeriesChart *widget;
        std::vector<ChartLine> lines;
        AxisScale scale;
    };
    void addPlot(const QString &name, const QString &title, const QString &unit, double least, std::vector<ChartLine> lines);

    SampleHistory m_history;
    std::vector<Plot> m_charts;
    SuiteLegend *m_legend;
    QComboBox *m_span;
    QCheckBox *m_freeze;
    QLabel *m_cost;
    QTimer *m_timer; ///< runs only while the charts can be seen
    bool m_fresh = false;
};

} // namespace skyseal::ui
