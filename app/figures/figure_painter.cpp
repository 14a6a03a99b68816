#include "app/figures/figure_painter.h"

#include <QtCore/QFile>
#include <QtCore/QXmlStreamReader>
#include <QtGui/QFont>
#include <QtGui/QFontMetricsF>
#include <QtGui/QPainter>

namespace skyseal::app {

namespace {

double number(const QXmlStreamAttributes &attributes, const char *name, double preset = 0)
{
    bool ok = false;
    const double value = attributes.value(QLatin1String(name)).toDouble(&ok);
    return ok ? value : preset;
}

QColor colour(const QXmlStreamAttributes &attributes, const char *name)
{
    return QColor(attributes.value(QLatin1String(name)).toString());
}

} // namespace

bool FigurePainter::load(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return false;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const QString name = xml.name().toString();
        if (name == QLatin1String("svg")) {
            m_size = QSizeF(number(xml.attributes(), "width"), number(xml.attributes(), "height"));
            m_family = xml.attributes().value(QLatin1String("font-family")).toString().section(QLatin1Char(','), 0, 0);
        } else if (name == QLatin1String("rect") || name == QLatin1String("line") || name == QLatin1String("circle")) {
            m_elements.append({name, xml.attributes(), {}});
            xml.skipCurrentElement();
        } else if (name == QLatin1String("text")) {
            const QXmlStreamAttributes attributes = xml.attributes();
            m_elements.append({name, attributes, xml.readElementText()});
        } else {
            return false;
        }
    }
    return !xml.hasError() && m_size.isValid() && !m_size.isEmpty();
}

void FigurePainter::draw(QPainter &painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Element &element : m_elements)
        drawElement(painter, element);
}

void FigurePainter::drawElement(QPainter &painter, const Element &element) const
{
    const QXmlStreamAttributes &a = element.attributes;
    const bool stroked = a.hasAttribute(QLatin1String("stroke"));
    const bool filled = a.hasAttribute(QLatin1String("fill"));
    painter.setPen(stroked ? QPen(colour(a, "stroke"), number(a, "stroke-width", 1)) : QPen(Qt::NoPen));
    painter.setBrush(filled ? QBrush(colour(a, "fill")) : QBrush(Qt::NoBrush));
    if (element.name == QLatin1String("rect"))
        painter.drawRect(QRectF(number(a, "x"), number(a, "y"), number(a, "width"), number(a, "height")));
    else if (element.name == QLatin1String("line"))
        painter.drawLine(QPointF(number(a, "x1"), number(a, "y1")), QPointF(number(a, "x2"), number(a, "y2")));
    else if (element.name == QLatin1String("circle"))
        painter.drawEllipse(QPointF(number(a, "cx"), number(a, "cy")), number(a, "r"), number(a, "r"));
    else
        drawText(painter, element);
}

void FigurePainter::drawText(QPainter &painter, const Element &element) const
{
    const QXmlStreamAttributes &a = element.attributes;
    constexpr double kFine = 16; // fonts have whole pixels, figures do not
    QFont font(m_family);
    font.setPixelSize(qRound(kFine * number(a, "font-size", 12)));
    font.setBold(a.value(QLatin1String("font-weight")) == QLatin1String("bold"));
    font.setItalic(a.value(QLatin1String("font-style")) == QLatin1String("italic"));
    const double width = QFontMetricsF(font).horizontalAdvance(element.text);
    const auto anchor = a.value(QLatin1String("text-anchor"));
    const double back = anchor == QLatin1String("middle") ? width / 2 : anchor == QLatin1String("end") ? width : 0;
    painter.save();
    painter.translate(number(a, "x"), number(a, "y"));
    painter.scale(1 / kFine, 1 / kFine);
    painter.setFont(font);
    painter.setPen(colour(a, "fill"));
    painter.drawText(QPointF(-back, 0), element.text);
    painter.restore();
}

} // namespace skyseal::app
