#include "ui/result_label.h"

#include "ui/text/plain_tip.h"

#include <QtGui/QPainter>
#include <QtGui/QTextLayout>

#include <algorithm>

namespace skyseal::ui {

ResultLabel::ResultLabel(QWidget *parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText); // results contain text of the vehicle
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ResultLabel::showResult(const QString &text)
{
    m_time = text.isEmpty() ? QString() : QTime::currentTime().toString(QStringLiteral("HH:mm:ss"));
    setText(text);
    setToolTip(text.isEmpty() ? QString() : plainTip(m_time + QLatin1Char(' ') + text));
    update(); // the same result again has another time
}

QSize ResultLabel::sizeHint() const
{
    return {0, kLines * fontMetrics().lineSpacing()};
}

QSize ResultLabel::minimumSizeHint() const
{
    return sizeHint();
}

QString ResultLabel::time() const
{
    return m_time + QStringLiteral("  ");
}

QStringList ResultLabel::shownLines() const
{
    const int most = std::max(kLines, height() / fontMetrics().lineSpacing());
    QTextOption wrapping;
    wrapping.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    QTextLayout layout(text(), font());
    layout.setTextOption(wrapping);
    layout.beginLayout();
    QStringList lines;
    while (lines.size() < most) {
        QTextLine line = layout.createLine();
        if (!line.isValid())
            break;
        line.setLineWidth(width() - (lines.isEmpty() ? fontMetrics().horizontalAdvance(time()) : 0));
        lines << (lines.size() + 1 < most ? text().mid(line.textStart(), line.textLength())
                                          : fontMetrics().elidedText(text().mid(line.textStart()), Qt::ElideRight, width()));
    }
    layout.endLayout();
    return lines;
}

void ResultLabel::paintEvent(QPaintEvent *)
{
    if (text().isEmpty())
        return;
    const QStringList lines = shownLines();
    const int spacing = fontMetrics().lineSpacing();
    int baseline = (height() - std::max<int>(kLines, lines.size()) * spacing) / 2 + fontMetrics().ascent();
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(0, baseline, m_time);
    painter.setPen(palette().color(foregroundRole()));
    int left = fontMetrics().horizontalAdvance(time());
    for (const QString &line : lines) {
        painter.drawText(left, baseline, line);
        left = 0;
        baseline += spacing;
    }
}

} // namespace skyseal::ui

#include "moc_result_label.cpp"
