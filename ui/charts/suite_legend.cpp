#include "ui/charts/suite_legend.h"

#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtGui/QPainter>

#include <cmath>

namespace skyseal::ui {

SuiteLegend::SuiteLegend(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("suiteLegend"));
    setAccessibleName(tr("Legend"));
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void SuiteLegend::setSuites(const std::vector<crypto::SuiteId> &suites)
{
    if (suites == m_suites)
        return;
    m_suites = suites;
    setAccessibleDescription(names().join(QStringLiteral(", ")));
    updateGeometry();
    update();
}

QStringList SuiteLegend::names() const
{
    QStringList out;
    for (const crypto::SuiteId suite : m_suites)
        out << suiteName(suite);
    return out;
}

std::vector<SuiteLegend::Entry> SuiteLegend::arranged(int width, int *height) const
{
    constexpr qreal kSwatch = 20;
    const QFontMetricsF metrics(font());
    std::vector<Entry> out;
    QPointF at(kGrid, 0);
    for (const crypto::SuiteId suite : m_suites) {
        const QString name = suiteName(suite);
        const qreal wide = kSwatch + metrics.horizontalAdvance(name);
        if (at.x() > kGrid && at.x() + wide > width)
            at = {kGrid, at.y() + metrics.height() + 1};
        out.push_back({suite, name, at});
        at.rx() += wide + 2 * kGrid;
    }
    *height = static_cast<int>(std::ceil(at.y() + metrics.height())) + 2;
    return out;
}

int SuiteLegend::heightForWidth(int width) const
{
    int height = 0;
    arranged(width, &height);
    return height;
}

QSize SuiteLegend::sizeHint() const
{
    return {320, heightForWidth(width())};
}

QSize SuiteLegend::minimumSizeHint() const
{
    return {0, fontMetrics().height() + 2};
}

void SuiteLegend::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(font());
    int used = 0;
    const std::vector<Entry> entries = arranged(width(), &used);
    const qreal top = (height() - used) / 2.0 + 1;
    for (const Entry &entry : entries) {
        const qreal line = top + entry.at.y();
        painter.setPen(Qt::NoPen);
        painter.setBrush(suiteColor(entry.suite));
        painter.drawRoundedRect(QRectF(entry.at.x(), line + metrics.height() / 2 - 2, 14, 4), 2, 2);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QPointF(entry.at.x() + 20, line + metrics.ascent()), entry.name);
    }
}

} // namespace skyseal::ui

#include "moc_suite_legend.cpp"
