#include "ui/charts/qt_time_series_chart.h"

#include "ui/text/figures.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCharts/QChart>
#include <QtCharts/QLineSeries>
#include <QtCharts/QValueAxis>
#include <QtCore/QEvent>
#include <QtGui/QPainter>
#include <QtWidgets/QGraphicsLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QVBoxLayout>

#include <algorithm>

namespace skyseal::ui {

namespace {
constexpr int kTimeTicks = 5, kValueTicks = 3;
}

MarkedChartView::MarkedChartView(QChart *chart, QWidget *parent) : QChartView(chart, parent)
{
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing, false);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setFocusPolicy(Qt::NoFocus);
}

void MarkedChartView::setMarks(const std::vector<ChartMark> &marks, double span, double top)
{
    m_marks = marks;
    m_span = span;
    m_top = top;
}

void MarkedChartView::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    const QFontMetrics metrics(labelFont());
    const int left = metrics.horizontalAdvance(QStringLiteral("88888")) + kGrid;
    chart()->setPlotArea(
        QRectF(left, metrics.height() / 2.0, width() - left - 2 * kGrid, height() - 2.0 * metrics.height() - 2));
}

QFont MarkedChartView::labelFont() const
{
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1.5));
    return small;
}

void MarkedChartView::drawLabels(QPainter &painter, const QRectF &area) const
{
    painter.setFont(labelFont());
    painter.setPen(stateColors(palette()).dim);
    const QFontMetricsF metrics(labelFont());
    const int decimals = m_top >= 10 ? 0 : m_top < 0.5 ? 2 : 1;
    for (int i = 0; i < kValueTicks; ++i) {
        const double part = static_cast<double>(i) / (kValueTicks - 1);
        const QString text = number(part * m_top, decimals);
        const double y = area.bottom() - part * area.height();
        drawFigures(painter, QPointF(area.left() - kHalfGrid - figuresWidth(metrics, text), y + metrics.capHeight() / 2),
                    text);
    }
    for (int i = 0; i < kTimeTicks; ++i) {
        const double part = static_cast<double>(i) / (kTimeTicks - 1);
        const QString text = i == kTimeTicks - 1 ? tr("now") : tr("%1 s").arg(number((part - 1) * m_span, 0));
        const double x = area.left() + part * area.width();
        const double width = figuresWidth(metrics, text);
        const double left = i == 0                ? x
                            : i == kTimeTicks - 1 ? x - width
                                                  : x - width / 2; // the outer ones stay under the plot
        drawFigures(painter, QPointF(left, area.bottom() + metrics.height() + 2), text);
    }
}

void MarkedChartView::drawForeground(QPainter *painter, const QRectF &)
{
    const QRectF area = chart()->plotArea();
    drawLabels(*painter, area);
    for (const ChartMark &mark : m_marks) {
        const qreal x = area.right() + mark.x / m_span * area.width();
        if (x < area.left())
            continue;
        painter->setPen(QPen(mark.color, 1, Qt::DashLine));
        painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter->setPen(Qt::NoPen);
        painter->setBrush(mark.color);
        const QPointF tip[] = {{x - 4, area.top()}, {x + 4, area.top()}, {x, area.top() + 6}};
        painter->drawPolygon(tip, 3);
    }
}

QtTimeSeriesChart::QtTimeSeriesChart(const QString &title, const QString &unit, QWidget *parent) : TimeSeriesChart(parent)
{
    setAccessibleName(title);
    m_chart = new QChart;
    m_chart->legend()->hide();
    m_chart->setMargins(QMargins(0, 0, kGrid, 0));
    m_chart->layout()->setContentsMargins(0, 0, 0, 0);
    m_chart->setBackgroundRoundness(0);
    m_chart->setAnimationOptions(QChart::NoAnimation);
    m_time = new QValueAxis(m_chart);
    m_time->setTickCount(kTimeTicks);
    m_time->setLabelsVisible(false); // the view writes them: Qt Charts lays out a text document for each at every redraw
    m_value = new QValueAxis(m_chart);
    m_value->setTickCount(kValueTicks);
    m_value->setLabelsVisible(false);
    m_chart->addAxis(m_time, Qt::AlignBottom);
    m_chart->addAxis(m_value, Qt::AlignLeft);

    m_title = new QLabel(unit.isEmpty() ? title : tr("%1, %2").arg(title, unit), this);
    m_title->setContentsMargins(kGrid, 0, 0, 0);
    m_view = new MarkedChartView(m_chart, this);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_view, 1);
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
    if (m_time->min() != -content.span || m_time->max() != 0)
        m_time->setRange(-content.span, 0);
    if (m_value->max() != content.top)
        m_value->setRange(0, content.top);
    m_view->setMarks(content.marks, content.span, content.top);
    for (std::size_t i = 0; i < content.runs.size(); ++i) {
        const ChartRun &run = content.runs[i];
        QLineSeries *line = series(i);
        const QPen pen(run.color, run.dashed ? 1.2 : 2, run.dashed ? Qt::DotLine : Qt::SolidLine);
        if (line->pen() != pen)
            line->setPen(pen);
        line->replace(QList<QPointF>(run.points.begin(), run.points.end()));
        if (!line->isVisible())
            line->show();
    }
    for (std::size_t i = content.runs.size(); i < m_used; ++i) {
        m_series[i]->clear();
        m_series[i]->hide();
    }
    m_used = content.runs.size();
    m_view->viewport()->update();
}

ChartContent QtTimeSeriesChart::plotted() const
{
    ChartContent out;
    out.span = -m_time->min();
    out.top = m_value->max();
    out.marks = m_view->marks();
    for (std::size_t i = 0; i < m_used; ++i) {
        const auto points = m_series[i]->points();
        out.runs.push_back(
            {m_series[i]->pen().color(), m_series[i]->pen().style() != Qt::SolidLine, {points.begin(), points.end()}});
    }
    return out;
}

void QtTimeSeriesChart::applyColors()
{
    const StateColors &colors = stateColors(palette());
    m_chart->setBackgroundBrush(palette().color(QPalette::Window));
    m_chart->setBackgroundPen(Qt::NoPen);
    m_view->setBackgroundBrush(palette().color(QPalette::Window));
    for (QValueAxis *axis : {m_time, m_value}) {
        axis->setGridLineColor(colors.line);
        axis->setLinePenColor(colors.line);
    }
}

void QtTimeSeriesChart::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        applyColors();
    TimeSeriesChart::changeEvent(event);
}

TimeSeriesChart *makeTimeSeriesChart(const QString &title, const QString &unit, QWidget *parent)
{
    return new QtTimeSeriesChart(title, unit, parent);
}

} // namespace skyseal::ui
