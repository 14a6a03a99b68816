#include "ui/result_label.h"

#include "ui/text/plain_tip.h"

#include <QtGui/QPainter>
#include <QtGui/QTextLayout>

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

void ResultLabel::paintEvent(QPaintEvent *)
{
    if (text().isEmpty())
        return;
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(0, fontMetrics().ascent(), m_time);
    const int indent = fontMetrics().horizontalAdvance(m_time + QStringLiteral("  ")); // of the first line
    painter.setPen(palette().color(foregroundRole()));
    QTextOption wrapping;
    wrapping.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    QTextLayout layout(text(), font());
    layout.setTextOption(wrapping);
    layout.beginLayout();
    for (int i = 0; i < kLines; ++i) {
        QTextLine line = layout.createLine();
        if (!line.isValid())
            break;
        const int left = i == 0 ? indent : 0;
        line.setLineWidth(width() - left);
        const int top = i * fontMetrics().lineSpacing();
        const QString shown = i + 1 < kLines ? text().mid(line.textStart(), line.textLength())
                                             : fontMetrics().elidedText(text().mid(line.textStart()), Qt::ElideRight, width());
        painter.drawText(left, top + fontMetrics().ascent(), shown);
    }
    layout.endLayout();
}

} // namespace skyseal::ui
