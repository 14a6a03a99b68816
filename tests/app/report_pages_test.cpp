// The pages of report.pdf: no row of a table and no line is divided, heads are repeated, headings stay with what follows.
#include "app/figures/report_pages.h"
#include "core/experiment/html_report.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtGui/QAbstractTextDocumentLayout>
#include <QtGui/QGuiApplication>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtGui/QTextBlock>
#include <QtGui/QTextDocument>
#include <QtGui/QTextTable>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::app;
using namespace skyseal::experiment;

namespace {

constexpr QSizeF kPaper(1032, 703); // A4 across, without margins

/// Lines and rows of equal height, one below the other.
std::vector<PageUnit> unitsOf(std::size_t count, double height)
{
    std::vector<PageUnit> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        out[i].top = static_cast<double>(i) * height;
        out[i].bottom = out[i].top + height;
    }
    return out;
}

/// The same as the rows of one table, the first of which is its head.
std::vector<PageUnit> tableOf(std::size_t rows, double height, std::vector<TableExtent> &tables)
{
    std::vector<PageUnit> out = unitsOf(rows, height);
    for (PageUnit &row : out)
        row.table = tables.size();
    out.front().keepsNext = true;
    tables.push_back({0, height, static_cast<double>(rows) * height});
    return out;
}

/// Every suite, twice ten runs, of which some have notes of several lines.
std::string reportOf()
{
    Results results;
    for (const crypto::SuiteInfo &info : crypto::suites())
        results.plan.arms.push_back({info.id});
    results.plan.repeats = 10;
    results.plan.conditions = {*parseCondition("loss=0.1")};
    results.setting = {{"machine", QString(QStringLiteral("a setting of many words ")).repeated(150).toStdString()}};
    for (const Run &run : schedule(results.plan)) {
        Sample sample;
        sample.run = run;
        sample.order = static_cast<unsigned>(results.samples.size());
        for (const MetricInfo &metric : metrics())
            sample.values[metric.metric] = 1 + 0.01 * static_cast<double>((run.repeat * 3 + run.arm) % 5);
        if (sample.order % 3 == 0)
            sample.invalid = "not saturated: " + QString(QStringLiteral("for a reason ")).repeated(40).toStdString();
        sample.begin.relay = sample.end.relay = Counted::Relay{};
        results.samples.push_back(sample);
    }
    return printReport({results, {}, {}, {}});
}

/// The only slice that the rectangle is in; nullptr if it is cut.
const PageSlice *pageOf(const ReportPages &pages, const QRectF &rect)
{
    const auto found = std::ranges::find_if(pages.slices(), [&](const PageSlice &slice) {
        return rect.top() >= slice.top - 0.01 && rect.bottom() <= slice.bottom + 0.01;
    });
    return found == pages.slices().end() ? nullptr : &*found;
}

} // namespace

class ReportPagesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pagesEndBetweenUnits();
    void headIsRepeated();
    void smallTableStaysWhole();
    void headingStaysWithItsText();
    void sectionsBeginPages();
    void higherThanAPageIsDivided();
    void noRowOfAReportIsDivided();
    void pdfHasThesePages();
};

void ReportPagesTest::pagesEndBetweenUnits()
{
    const auto pages = paginate(unitsOf(10, 30), {}, 100);
    QCOMPARE(pages.size(), std::size_t(4));
    for (std::size_t i = 0; i < pages.size(); ++i) {
        QCOMPARE(pages[i].top, 90.0 * static_cast<double>(i));
        QCOMPARE(pages[i].bottom, std::min(300.0, pages[i].top + 90));
        QVERIFY(!pages[i].head);
    }
    QVERIFY(paginate({}, {}, 100).empty());
}

void ReportPagesTest::headIsRepeated()
{
    std::vector<TableExtent> tables;
    const auto units = tableOf(8, 30, tables);
    const auto pages = paginate(units, tables, 100);
    QCOMPARE(pages.size(), std::size_t(4)); // the head and two rows, then two rows below the head
    QVERIFY(!pages[0].head);
    for (std::size_t i = 1; i < pages.size(); ++i) {
        QCOMPARE(pages[i].head, std::optional<std::size_t>(0));
        QCOMPARE(pages[i].top, 90 + 60.0 * static_cast<double>(i - 1));
    }
    QCOMPARE(pages.back().bottom, 240.0);
}

void ReportPagesTest::smallTableStaysWhole()
{
    std::vector<TableExtent> tables;
    std::vector<PageUnit> units = unitsOf(3, 30);
    units.back().keepsNext = true; // its heading
    for (PageUnit row : tableOf(4, 10, tables)) {
        row.top += 90;
        row.bottom += 90;
        units.push_back(row);
    }
    tables[0] = {90, 100, 130};
    const auto pages = paginate(units, tables, 100);
    QCOMPARE(pages.size(), std::size_t(2));
    QCOMPARE(pages[0].bottom, 60.0);
    QCOMPARE(pages[1].top, 60.0);
    QVERIFY(!pages[1].head);
}

void ReportPagesTest::headingStaysWithItsText()
{
    std::vector<PageUnit> units = unitsOf(5, 30);
    units[2].keepsNext = true;
    const auto pages = paginate(units, {}, 100);
    QCOMPARE(pages.size(), std::size_t(2));
    QCOMPARE(pages[1].top, 60.0);
}

void ReportPagesTest::sectionsBeginPages()
{
    std::vector<PageUnit> units = unitsOf(3, 10);
    units[1].beginsPage = true;
    const auto pages = paginate(units, {}, 100);
    QCOMPARE(pages.size(), std::size_t(2));
    QCOMPARE(pages[1].top, 10.0);
    QCOMPARE(pages[1].bottom, 30.0);
}

void ReportPagesTest::higherThanAPageIsDivided()
{
    std::vector<PageUnit> units = unitsOf(2, 250);
    const auto pages = paginate(units, {}, 100);
    double at = 0;
    for (const PageSlice &page : pages) {
        QCOMPARE(page.top, at);
        QVERIFY(page.bottom > page.top && page.bottom - page.top <= 100.01);
        at = page.bottom;
    }
    QCOMPARE(at, 500.0);
}

void ReportPagesTest::noRowOfAReportIsDivided()
{
    QTextDocument document;
    ReportPages::read(document, QString::fromStdString(reportOf()));
    const ReportPages pages(document, kPaper);
    QVERIFY(pages.slices().size() > 8);
    for (const PageSlice &slice : pages.slices()) {
        const double head = slice.head ? pages.tables()[*slice.head].headHeight() : 0;
        QVERIFY(slice.bottom - slice.top + head <= kPaper.height() + 0.01);
    }
    QAbstractTextDocumentLayout &layout = *document.documentLayout();
    const PageSlice *before = nullptr; // of a heading
    int rows = 0, repeated = 0;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (block.text().isEmpty())
            continue;
        const QRectF rect = layout.blockBoundingRect(block);
        const auto *table = QTextCursor(block).currentTable();
        const bool isLine = block.layout()->lineCount() == 1;
        const PageSlice *page = pageOf(pages, rect);
        QVERIFY2(page || (!table && !isLine), qPrintable(block.text())); // long paragraphs may go on
        const bool beginsPage = block.blockFormat().pageBreakPolicy() & QTextFormat::PageBreak_AlwaysBefore;
        if (before && page && !beginsPage) // a section without content may end a page
            QVERIFY2(page == before, qPrintable(block.text()));
        before = block.blockFormat().headingLevel() > 0 ? page : nullptr;
        if (!table)
            continue;
        // All cells of the row are on the page.
        const QTextTableCell cell = table->cellAt(QTextCursor(block));
        const QTextTableCell first = table->cellAt(cell.row(), 0);
        QCOMPARE(page, pageOf(pages, layout.blockBoundingRect(first.firstCursorPosition().block())));
        const QRectF whole = layout.frameBoundingRect(const_cast<QTextTable *>(table));
        if (cell.column() == 0 && page->top > whole.top() + 1) { // it began on an earlier page
            ++rows;
            QVERIFY(page->head);
            const TableExtent &extent = pages.tables()[*page->head];
            const QRectF head = layout.blockBoundingRect(table->cellAt(0, 0).firstCursorPosition().block());
            QVERIFY(extent.top < head.top() && extent.headBottom > head.bottom() && extent.top >= whole.top() - 10);
            repeated += cell.row() > 0;
        }
    }
    QVERIFY2(rows > 50 && repeated == rows, qPrintable(QString::number(rows)));

    // The head that is drawn again looks like the one at the beginning of the table.
    const auto picture = [&](const PageSlice &slice) {
        QImage out(kPaper.toSize(), QImage::Format_RGB32);
        out.fill(Qt::white);
        QPainter painter(&out);
        pages.draw(painter, slice);
        return out;
    };
    const auto continued = std::ranges::find_if(pages.slices(), [](const PageSlice &slice) { return slice.head.has_value(); });
    QVERIFY(continued != pages.slices().end());
    const TableExtent &table = pages.tables()[*continued->head];
    const QRect head(0, 1, int(kPaper.width()), int(table.headHeight()) - 2);
    QCOMPARE(picture(*continued).copy(head), picture({table.top, table.headBottom, {}}).copy(head));
    QVERIFY(picture(*continued).copy(head) != picture({continued->top, continued->bottom, {}}).copy(head));
}

void ReportPagesTest::pdfHasThesePages()
{
    QTemporaryDir folder;
    const QString report = folder.filePath(QStringLiteral("print.html")), pdf = folder.filePath(QStringLiteral("report.pdf"));
    const std::string html = reportOf();
    QFile file(report);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(html.data(), qint64(html.size())) == qint64(html.size()));
    file.close();
    const test::RunResult run = test::runProgram("skyseal-figures",
                                                 {QStringLiteral("--report"), report, QStringLiteral("--pdf"), pdf}, {}, 60000);
    QVERIFY2(run.status == 0, run.err.constData());
    QFile written(pdf);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QTextDocument document;
    ReportPages::read(document, QString::fromStdString(html));
    const auto pages = static_cast<qsizetype>(ReportPages(document, kPaper).slices().size());
    const qsizetype drawn = written.readAll().count("/Type /Page\n");
    QVERIFY2(std::abs(drawn - pages) <= 1, // fonts of a printer and of a screen differ by fractions of a pixel
             qPrintable(QStringLiteral("%1, %2").arg(drawn).arg(pages)));
}

SKYSEAL_TEST_ENTRY(ReportPagesTest, qputenv("QT_QPA_PLATFORM", "offscreen"); QGuiApplication application(argc, argv);)
#include "report_pages_test.moc"
