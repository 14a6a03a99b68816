// Draws the figures of a sweep, which are SVG of rect, line, circle and text alone, with a painter. Qt's own SVG renderer
// turns letters into outlines, which makes pages of megabytes whose text cannot be found.
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
    /// False when it cannot be read or holds what is not known here.
    bool load(const QString &file);
    QSizeF size() const { return m_size; }
    /// In units of the figure, from the painter's origin.
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
