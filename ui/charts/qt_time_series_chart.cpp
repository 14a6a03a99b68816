#include "ui/charts/qt_time_series_chart.h"

#include "ui/charts/chart_cursor.h"
#include "ui/charts/chart_view.h"
#include "ui/charts/chart_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCharts/QLineSeries>
#include <QtCharts/QValueAxis>
#include <QtCore/QEvent>
#include <QtWidgets/QGraphicsLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

namespace {

QPen penOf(const ChartRun &run)
{
    switch (run.stroke) {
    case Stroke::Solid: return QPen(run.color, 2);
    case Stroke::Dashed: return QPen(run.color, 1.4, Qt::DashLine);
    case Stroke::Dotted: return QPen(run.color, 1.4, Qt::DotLine);
    }
    return {};
}

Stroke strokeOf(const QPen &pen)
{
    return pen.style() == Qt::SolidLine ? Stroke::Solid : pen.style() == Qt::DashLine ? Stroke::Dashed : Stroke::Dotted;
}

} // namespace

QtTimeSeriesChart::QtTimeSeriesChart(const ChartTitle &title, QWidget *parent) : TimeSeriesChart(parent)
{
    setAccessibleName(title.name);
    setAccessibleDescription(title.note);
    m_chart = new QChart;
    m_chart->legend()->hide();
    m_chart->setMargins(QMargins(0, 0, 0, 0));
    m_chart->layout()->setContentsMargins(0, 0, 0, 0);
    m_chart->setBackgroundVisible(false);
    m_time = new QValueAxis(m_chart);
    m_value = new QValueAxis(m_chart);
    for (QValueAxis *axis : {m_time, m_value}) {
        // ChartPainter paints grid and labels, at less than half the cost (BENCHMARKS.md, Window): Qt Charts lays out a text
        // document for each label, and does not move its grid with a fixed plot area.
        axis->setLabelsVisible(false);
        axis->setGridLineVisible(false);
        axis->setLineVisible(false);
    }
    m_chart->addAxis(m_time, Qt::AlignBottom);
    m_chart->addAxis(m_value, Qt::AlignLeft);

    m_titleText = tr("%1, %2").arg(title.name, title.unit);
    if (!title.key.isEmpty())
        m_titleText = tr("%1 · %2").arg(m_titleText, title.key);
    m_title = new QLabel(m_titleText, this);
    m_title->setContentsMargins(kGrid, 0, 0, 0);
    m_title->setToolTip(
        QStringLiteral("<p><b>%1</b></p><p>%2</p>").arg(m_titleText.toHtmlEscaped(), title.note.toHtmlEscaped()));
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_view = new ChartView(m_chart, this);
    m_view->setUnit(title.unit);
    if (!title.remark.isEmpty())
        m_view->setEmptyText(title.remark);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_view, 1);
    connect(m_view, &ChartView::hovered, this, &TimeSeriesChart::hovered);
    connect(m_view, &ChartView::hoverEnded, this, &TimeSeriesChart::hoverEnded);
    connect(m_view, &ChartView::zoomRequested, this, &TimeSeriesChart::zoomRequested);
    connect(m_view, &ChartView::rangeRequested, this, &TimeSeriesChart::rangeRequested);
    connect(m_view, &ChartView::liveRequested, this, &TimeSeriesChart::liveRequested);
    applyColors();
    showContent({});
}

QLineSeries *QtTimeSeriesChart::series(std::size_t index)
{
    while (m_series.size() <= index) {
        auto *line = new QLineSeries(m_chart);
        m_chart->addSeries(line);
        line->attachAxis(m_time);
        line->attachAxis(m_value);
        m_series.push_back(line);
    }
    return m_series[index];
}

void QtTimeSeriesChart::showContent(const ChartContent &content)
{
    if (m_time->min() != content.from || m_time->max() != content.to)
        m_time->setRange(content.from, content.to);
    if (m_value->max() != content.top)
        m_value->setRange(0, content.top);
    m_view->setFrame(content, !content.runs.empty());
    m_names.clear();
    for (std::size_t i = 0; i < content.runs.size(); ++i) {
        const ChartRun &run = content.runs[i];
        QLineSeries *line = series(i);
        const QPen pen = penOf(run);
        if (line->pen() != pen)
            line->setPen(pen);
        line->replace(QList<QPointF>(run.points.begin(), run.points.end()));
        if (!line->isVisible())
            line->show();
        m_names.emplace_back(run.line, run.suite);
    }
    for (std::size_t i = content.runs.size(); i < m_used; ++i) {
        m_series[i]->clear();
        m_series[i]->hide();
    }
    m_used = content.runs.size();
    m_view->viewport()->update();
    if (m_cursor)
        showCursor(m_cursor);
}

ChartContent QtTimeSeriesChart::plotted() const
{
    ChartContent out = m_view->plot().content;
    out.from = m_time->min();
    out.to = m_time->max();
    out.top = m_value->max();
    for (std::size_t i = 0; i < m_used; ++i) {
        const auto points = m_series[i]->points();
        out.runs.push_back({m_series[i]->pen().color(),
                            strokeOf(m_series[i]->pen()),
                            m_names[i].first,
                            m_names[i].second,
                            {points.begin(), points.end()}});
    }
    return out;
}

void QtTimeSeriesChart::showCursor(std::optional<double> x)
{
    m_cursor = x;
    if (!x) {
        m_view->cursorLayer()->clear();
        return;
    }
    constexpr double kMarkReach = 5; // pixels
    const int decimals = m_value->max() >= 1000 ? 0 : m_value->max() >= 20 ? 1 : m_value->max() >= 2 ? 2 : 3;
    const ChartContent content = plotted();
    const ChartPlot &plot = m_view->plot();
    std::vector<QPointF> curves;
    for (const ChartRun &run : content.runs) {
        for (const QPointF &point : run.points)
            curves.emplace_back(plot.xOf(point.x()), plot.area.bottom() - point.y() / content.top * plot.area.height());
    }
    m_view->cursorLayer()->showAt(plot.xOf(*x), plot.area,
                                  chartTextAt(content, *x, kMarkReach * plot.secondsPerPixel(), decimals), curves);
}

QStringList QtTimeSeriesChart::cursorText() const
{
    return m_view->cursorLayer()->lines();
}

void QtTimeSeriesChart::applyColors()
{
    m_view->setBackgroundBrush(palette().color(QPalette::Window));
}

void QtTimeSeriesChart::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        applyColors();
    TimeSeriesChart::changeEvent(event);
}

void QtTimeSeriesChart::resizeEvent(QResizeEvent *event)
{
    m_title->setText(m_title->fontMetrics().elidedText(m_titleText, Qt::ElideRight, width() - 2 * kGrid));
    TimeSeriesChart::resizeEvent(event);
}

TimeSeriesChart *makeTimeSeriesChart(const ChartTitle &title, QWidget *parent)
{
    return new QtTimeSeriesChart(title, parent);
}

} // namespace skyseal::ui

#include "moc_qt_time_series_chart.cpp"
