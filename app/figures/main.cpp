// skyseal-figures: renders a sweep's figures as PNG and PDF and its report as PDF, without a display. Programs that write a
// report start it if it is installed.
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/figures/figure_painter.h"
#include "app/figures/report_pages.h"
#include "core/base/save_file.h"

#include <QtCore/QBuffer>
#include <QtCore/QDateTime>
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QHash>
#include <QtCore/QTemporaryDir>
#include <QtGui/QAbstractTextDocumentLayout>
#include <QtGui/QGuiApplication>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtGui/QPdfWriter>
#include <QtGui/QTextDocument>
#include <QtGui/QTextObjectInterface>

#include <algorithm>

using namespace skyseal::app;

namespace {

const QString kName = QStringLiteral("skyseal-figures");
constexpr int kPictureScale = 2;
constexpr int kDotsPerInch = 96;
constexpr double kGap = 8; ///< around a figure, of two beside each other

/// Says what went wrong.
bool save(const QString &path, const QByteArray &content)
{
    const auto saved = skyseal::saveFile(path.toStdString(), skyseal::asBytes({content.data(), std::size_t(content.size())}));
    if (!saved)
        complain(kName, saved.error().text());
    return saved.has_value();
}

#ifdef Q_MOC_RUN // which reads no headers (SkysealTargets.cmake)
Q_DECLARE_INTERFACE(QTextObjectInterface, "org.qt-project.Qt.QTextObjectInterface")
#endif

/// Draws the report's figures as vectors and text, not as pixels.
class FigureDrawer : public QObject, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    /// `width`: the space for a figure on the page.
    FigureDrawer(QString folder, double width) : m_folder(std::move(folder)), m_width(width) {}

    QSizeF intrinsicSize(QTextDocument *, int, const QTextFormat &format) override
    {
        FigurePainter figure;
        return figure.load(file(format)) ? figure.size() * std::min(1.0, m_width / figure.size().width()) : QSizeF();
    }
    void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *, int, const QTextFormat &format) override
    {
        FigurePainter figure;
        if (!figure.load(file(format)))
            return;
        painter->save();
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / figure.size().width(), rect.height() / figure.size().height());
        figure.draw(*painter);
        painter->restore();
    }

private:
    QString file(const QTextFormat &format) const { return m_folder + QLatin1Char('/') + format.toImageFormat().name(); }

    QString m_folder;
    double m_width;
};

/// Qt dates a PDF with the time of its writing. With the time of the sweep, the same sweep gives the same bytes. The other text
/// is as long, in UTC, so that the offsets within the file stay valid. Without a valid time nothing changes.
QByteArray dated(QByteArray pdf, const QDateTime &time)
{
    if (!time.isValid())
        return pdf;
    const QByteArray begin = "/CreationDate (";
    const qsizetype at = pdf.indexOf(begin), end = pdf.indexOf(')', at);
    const QByteArray text = time.toUTC().toString(QStringLiteral("'D:'yyyyMMddHHmmss'Z'")).toLatin1();
    if (at >= 0 && end - at - begin.size() == text.size())
        pdf.replace(at + begin.size(), text.size(), text);
    return pdf;
}

QByteArray pictureOf(const FigurePainter &figure)
{
    QImage image((figure.size() * kPictureScale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(kPictureScale, kPictureScale);
    figure.draw(painter);
    painter.end();
    QBuffer png;
    return image.save(&png, "PNG") ? png.data() : QByteArray();
}

/// One page of the figure's own size, 333 pixels are 88 mm.
QByteArray pageOf(const FigurePainter &figure, const QDateTime &time)
{
    constexpr double kPointsPerInch = 72;
    QBuffer written;
    written.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&written);
        writer.setPageSize(
            QPageSize(figure.size() * kPointsPerInch / kDotsPerInch, QPageSize::Point, QString(), QPageSize::ExactMatch));
        writer.setPageMargins(QMarginsF());
        writer.setResolution(kDotsPerInch);
        QPainter painter(&writer);
        figure.draw(painter);
        if (!painter.end())
            return {};
    }
    return dated(written.data(), time);
}

/// FILE.png and FILE.pdf of FILE.svg.
bool drawPictures(const QString &file, const QDateTime &time)
{
    const QString path = QFileInfo(file).path() + QLatin1Char('/') + QFileInfo(file).completeBaseName();
    FigurePainter figure;
    const bool isLoaded = figure.load(file);
    const QByteArray picture = isLoaded ? pictureOf(figure) : QByteArray(),
                     page = isLoaded ? pageOf(figure, time) : QByteArray();
    if (picture.isEmpty() || page.isEmpty()) {
        complain(kName, file.toStdString() + ": cannot be drawn");
        return false;
    }
    return save(path + QStringLiteral(".png"), picture) && save(path + QStringLiteral(".pdf"), page);
}

/// `time`: of the report; not valid: now.
bool writePages(const QString &report, const QString &pages, const QDateTime &time)
{
    QFile file(report);
    if (!file.open(QIODevice::ReadOnly)) {
        complain(kName, report.toStdString() + ": " + file.errorString().toStdString());
        return false;
    }
    QBuffer written;
    written.open(QIODevice::WriteOnly);
    QPdfWriter writer(&written);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageOrientation(QPageLayout::Landscape); // tables have a column for each suite
    writer.setPageMargins(QMarginsF(12, 12, 12, 12), QPageLayout::Millimeter);
    writer.setResolution(kDotsPerInch);
    writer.setTitle(QStringLiteral("Skyseal sweep"));
    const QSizeF page(writer.width(), writer.height());
    FigureDrawer drawer(QFileInfo(report).path(), page.width() / 2 - kGap);
    QTextDocument document;
    document.documentLayout()->setPaintDevice(&writer);
    document.documentLayout()->registerHandler(QTextFormat::ImageObject, &drawer);
    ReportPages::read(document, QString::fromUtf8(file.readAll()));
    const ReportPages drawn(document, page);
    QPainter painter(&writer);
    for (const PageSlice &slice : drawn.slices()) {
        if (&slice != &drawn.slices().front())
            writer.newPage();
        drawn.draw(painter, slice);
    }
    if (!painter.end()) {
        complain(kName, pages.toStdString() + ": cannot be drawn");
        return false;
    }
    return save(pages, dated(written.data(), time));
}

} // namespace

int main(int argc, char **argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("TZ", "UTC0"); // of the date in a PDF
    // Qt warns if XDG_RUNTIME_DIR is not set, as in services and containers.
    const QTemporaryDir runtime;
    if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR") && runtime.isValid())
        qputenv("XDG_RUNTIME_DIR", QFile::encodeName(runtime.path()));
    QHashSeed::setDeterministicGlobalSeed(); // it decides the order of what a PDF embeds
    QGuiApplication application(argc, argv);
    Options options(kName,
                    QStringLiteral("Renders figures (FILE.svg to FILE.png and FILE.pdf) and a report (--report to --pdf)."));
    options.addValue("report", "FILE",
                     "Printable report of a sweep (HTML); the paths of its figures are relative to its folder.");
    options.addValue("pdf", "FILE", "PDF file to write.");
    options.addValue("date", "TIME", "Date of the PDF files, such as 2026-05-01T12:00:00Z. Default: now.");
    options.addArgument("FILE.svg", "Figures to render.");
    if (const auto status = options.parse(application.arguments().mid(1)))
        return *status;
    const QStringList figures = options.arguments(0, 10000);
    if (options.has("report") != options.has("pdf"))
        options.fail("--report and --pdf require each other");
    const QDateTime date = QDateTime::fromString(QString::fromStdString(options.text("date")), Qt::ISODate);
    if (options.has("date") && !date.isValid())
        options.fail("--date '" + options.text("date") + "': a time like 2026-05-01T12:00:00Z is expected");
    if (const auto status = options.finish())
        return *status;
    bool ok = true;
    for (const QString &figure : figures)
        ok = drawPictures(figure, date) && ok;
    if (options.has("report"))
        ok = writePages(QString::fromStdString(options.text("report")), QString::fromStdString(options.text("pdf")), date)
            && ok;
    return ok ? kDone : kCannotOpen;
}

#include "main.moc"
