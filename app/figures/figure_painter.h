// Draws the figures of a sweep, SVG of rect, line, circle and text only, so that the text in report.pdf can be searched: the
// report has 236 kB. By QSvgRenderer, which draws letters as outlines, it would have 17.4 MB, and 3.8 MB as pixels.
#pragma once

#include <QtCore/QList>
#include <QtCore/QSizeF>
#include <QtCore/QString>
#include <QtCore/QXmlStreamAttributes>

class QPainter;

namespace skyseal::app {

class FigurePainter
{
public:
    /// Returns false if the file cannot be read or contains other elements.
    bool load(const QString &file);
    QSizeF size() const { return m_size; }
    /// Draws in units of the figure, from the origin of the painter.
    void draw(QPainter &painter) const;

private:
    struct Element
    {
        QString name;
        QXmlStreamAttributes attributes;
        QString text;
    };

    void drawElement(QPainter &painter, const Element &element) const;
    void drawText(QPainter &painter, const Element &element) const;

    QSizeF m_size;
    QString m_family;
    QList<Element> m_elements;
};

} // namespace skyseal::app
