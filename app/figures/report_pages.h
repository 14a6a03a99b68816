// The pages of a printable report: a rich text without page breaks of its own, cut as pagination.h says. Qt's own pages divide
// the rows of tables. Needs a QGuiApplication; main thread.
#pragma once

#include "app/figures/pagination.h"

#include <QtCore/QRectF>
#include <QtCore/QSizeF>
#include <QtCore/QString>

class QPainter;
class QTextBlock;
class QTextDocument;
class QTextFrame;
class QTextTable;

namespace skyseal::app {

class ReportPages
{
public:
    /// Reads the report (printReport()) into an empty document, in the style of a printed page.
    static void read(QTextDocument &document, const QString &html);

    /// Lays the document out in the width of a page. It must outlive this object, unchanged.
    ReportPages(QTextDocument &document, QSizeF page);

    const std::vector<PageSlice> &slices() const { return m_slices; }
    const std::vector<TableExtent> &tables() const { return m_tables; }
    /// Draws at the origin of the painter, in the document's units.
    void draw(QPainter &painter, const PageSlice &slice) const;

private:
    void addFrame(const QTextFrame &frame);
    void addBlock(const QTextBlock &block);
    void addTable(const QTextTable &table);
    QRectF cellsOfRow(const QTextTable &table, int row) const;
    void drawStrip(QPainter &painter, double top, double bottom, double at) const;

    QTextDocument &m_document;
    QSizeF m_page;
    std::vector<PageUnit> m_units;
    std::vector<TableExtent> m_tables;
    std::vector<QRectF> m_borders; ///< of each table; empty without a border
    std::vector<PageSlice> m_slices;
};

} // namespace skyseal::app
