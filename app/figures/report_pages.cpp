#include "app/figures/report_pages.h"

#include <QtGui/QAbstractTextDocumentLayout>
#include <QtGui/QPainter>
#include <QtGui/QTextBlock>
#include <QtGui/QTextDocument>
#include <QtGui/QTextLayout>
#include <QtGui/QTextTable>

#include <algorithm>

namespace skyseal::app {

static constexpr double kLine = 1; ///< width of a table's border
static constexpr QColor kLineColor(0xcc, 0xcc, 0xcc);

void ReportPages::read(QTextDocument &document, const QString &html)
{
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(9);
    document.setDefaultFont(font);
    document.setDocumentMargin(0);
    document.setDefaultStyleSheet(
        QStringLiteral("table{border-color:#cccccc} th{background-color:#f0f3f7} .bad{color:#c00000} "
                       ".insecure{color:#a33c10} h1{font-size:20px} h2{font-size:14px} h3{font-size:11px}"));
    document.setHtml(html);
}

ReportPages::ReportPages(QTextDocument &document, QSizeF page) : m_document(document), m_page(page)
{
    document.setTextWidth(page.width()); // without a height, so that nothing is cut
    addFrame(*document.rootFrame());
    m_slices = paginate(m_units, m_tables, page.height());
}

void ReportPages::addFrame(const QTextFrame &frame)
{
    for (auto part = frame.begin(); !part.atEnd(); ++part) {
        if (const auto *table = qobject_cast<const QTextTable *>(part.currentFrame()))
            addTable(*table);
        else if (part.currentFrame())
            addFrame(*part.currentFrame());
        else
            addBlock(part.currentBlock());
    }
}

void ReportPages::addBlock(const QTextBlock &block)
{
    if (block.text().isEmpty()) // below a table
        return;
    const QTextLayout &lines = *block.layout();
    const double top = m_document.documentLayout()->blockBoundingRect(block).top();
    for (int i = 0; i < lines.lineCount(); ++i) {
        const double above = lines.lineAt(i).y() - lines.lineAt(0).y();
        PageUnit line{top + above, top + above + lines.lineAt(i).height(), {}, block.blockFormat().headingLevel() > 0};
        line.beginsPage = i == 0 && (block.blockFormat().pageBreakPolicy() & QTextFormat::PageBreak_AlwaysBefore);
        m_units.push_back(line);
    }
}

/// The contents of the row's cells, without their padding.
QRectF ReportPages::cellsOfRow(const QTextTable &table, int row) const
{
    QRectF out;
    for (int column = 0; column < table.columns(); ++column) {
        const QTextTableCell cell = table.cellAt(row, column);
        for (auto part = cell.begin(); !part.atEnd(); ++part) {
            if (part.currentBlock().isValid())
                out |= m_document.documentLayout()->blockBoundingRect(part.currentBlock());
        }
    }
    return out;
}

void ReportPages::addTable(const QTextTable &table)
{
    const QRectF whole = m_document.documentLayout()->frameBoundingRect(const_cast<QTextTable *>(&table));
    const int heads = table.format().headerRowCount();
    QRectF cells = cellsOfRow(table, 0);
    const double space = table.rows() > 1 ? (cellsOfRow(table, 1).top() - cells.bottom()) / 2 : 0; // padding and border
    TableExtent extent;
    extent.top = extent.headBottom = std::min(whole.top(), cells.top() - space);
    extent.bottom = std::max(whole.bottom(), cellsOfRow(table, table.rows() - 1).bottom() + space);
    double top = extent.top;
    for (int row = 0; row < table.rows(); ++row) {
        const bool isLast = row + 1 == table.rows();
        const QRectF next = isLast ? QRectF() : cellsOfRow(table, row + 1);
        PageUnit unit{top, isLast ? extent.bottom : (cells.bottom() + next.top()) / 2, m_tables.size()};
        // A row that is one cell is a note to the row above it.
        unit.keepsNext = row < heads
            || (!isLast && table.columns() > 1 && table.cellAt(row + 1, 0).columnSpan() == table.columns());
        if (row < heads)
            extent.headBottom = unit.bottom;
        m_units.push_back(unit);
        top = unit.bottom;
        cells = next;
    }
    m_tables.push_back(extent);
    m_borders.push_back(table.format().border() > 0 ? whole.translated(extent.top - whole.top(), 0) : QRectF());
}

void ReportPages::draw(QPainter &painter, const PageSlice &slice) const
{
    double at = 0;
    if (slice.head) {
        const TableExtent &table = m_tables[*slice.head];
        drawStrip(painter, table.top, table.headBottom, 0);
        at = table.headHeight();
    }
    drawStrip(painter, slice.top, slice.bottom, at);
    // The line below a row is drawn with the next one.
    for (std::size_t i = 0; i < m_tables.size(); ++i) {
        if (m_tables[i].top < slice.bottom - kLine && m_tables[i].bottom > slice.bottom + kLine && !m_borders[i].isEmpty())
            painter.fillRect(QRectF(m_borders[i].left(), at + slice.bottom - slice.top, m_borders[i].width(), kLine),
                             kLineColor);
    }
}

void ReportPages::drawStrip(QPainter &painter, double top, double bottom, double at) const
{
    constexpr double kEdge = 0.5; // what only touches the strip belongs to another one
    const QRectF strip(0, top, m_page.width(), bottom - top);
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = strip.adjusted(0, kEdge, 0, -kEdge);
    painter.save();
    painter.translate(0, at - top);
    painter.setClipRect(strip.adjusted(0, -kLine, 0, kLine));
    m_document.documentLayout()->draw(&painter, context);
    painter.restore();
}

} // namespace skyseal::app
