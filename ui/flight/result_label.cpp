#include "ui/flight/result_label.h"

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
    setText(text);
    setToolTip(plainTip(text));
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
    QPainter painter(this);
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
        line.setLineWidth(width());
        const int top = i * fontMetrics().lineSpacing();
        const QString shown = i + 1 < kLines ? text().mid(line.textStart(), line.textLength())
                                             : fontMetrics().elidedText(text().mid(line.textStart()), Qt::ElideRight, width());
        painter.drawText(0, top + fontMetrics().ascent(), shown);
    }
    layout.endLayout();
}

} // namespace skyseal::ui
