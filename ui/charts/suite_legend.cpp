#include "ui/charts/suite_legend.h"

#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtGui/QPainter>

namespace skyseal::ui {

SuiteLegend::SuiteLegend(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("suiteLegend"));
    setAccessibleName(tr("Legend"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SuiteLegend::setSuites(const std::vector<crypto::SuiteId> &suites)
{
    if (suites == m_suites)
        return;
    m_suites = suites;
    setAccessibleDescription(names().join(QStringLiteral(", ")));
    update();
}

QStringList SuiteLegend::names() const
{
    QStringList out;
    for (const crypto::SuiteId suite : m_suites)
        out << suiteName(suite);
    return out;
}

QSize SuiteLegend::sizeHint() const
{
    return {320, fontMetrics().height() + kHalfGrid};
}

void SuiteLegend::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(font());
    const qreal baseline = (height() + metrics.ascent() - metrics.descent()) / 2;
    qreal x = kGrid;
    for (const crypto::SuiteId suite : m_suites) {
        const QString name = suiteName(suite);
        painter.setPen(Qt::NoPen);
        painter.setBrush(suiteColor(suite));
        painter.drawRoundedRect(QRectF(x, height() / 2.0 - 2, 14, 4), 2, 2);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QPointF(x + 20, baseline), name);
        x += 20 + metrics.horizontalAdvance(name) + 2 * kGrid;
    }
}

} // namespace skyseal::ui
