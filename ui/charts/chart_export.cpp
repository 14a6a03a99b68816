#include "ui/charts/chart_export.h"

#include "core/base/save_file.h"
#include "core/engine/text/qt_text.h"

#include <QtCore/QBuffer>
#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>
#include <QtGui/QImageWriter>
#include <QtGui/QPainter>
#include <QtSvg/QSvgGenerator>
#include <QtWidgets/QWidget>

#include <algorithm>

namespace skyseal::ui {

namespace {

/// The translation context of the functions below.
struct ChartExportText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ChartExport)
};

void paintAll(QPainter &painter, const std::vector<QWidget *> &parts, const QSize &size)
{
    painter.fillRect(QRect(QPoint(), size), parts.front()->palette().color(QPalette::Window));
    int y = 0;
    for (QWidget *part : parts) {
        part->render(&painter, QPoint(0, y));
        y += part->height();
    }
}

QByteArray svgOf(const std::vector<QWidget *> &parts, const QSize &size)
{
    QBuffer out;
    QSvgGenerator generator;
    generator.setOutputDevice(&out);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(ChartExportText::tr("Skyseal diagnostics"));
    QPainter painter(&generator);
    paintAll(painter, parts, size);
    painter.end();
    return out.data();
}

} // namespace

QString writePicture(const QString &file, const std::vector<QWidget *> &parts)
{
    QSize size;
    for (const QWidget *part : parts)
        size = {std::max(size.width(), part->width()), size.height() + part->height()};
    if (file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive))
        return writeWhole(file, svgOf(parts, size));
    constexpr int kScale = 2;
    QImage image(size * kScale, QImage::Format_RGB32);
    image.setDevicePixelRatio(kScale);
    QPainter painter(&image);
    paintAll(painter, parts, size);
    painter.end();
    return writeImage(file, image);
}

QString writeImage(const QString &file, const QImage &image)
{
    QBuffer out;
    QImageWriter writer(&out, QFileInfo(file).suffix().toLatin1());
    if (!writer.write(image))
        return ChartExportText::tr("%1 cannot be written as a picture: %2").arg(file, writer.errorString());
    return writeWhole(file, out.data());
}

QString writeWhole(const QString &file, const QByteArray &content)
{
    const auto saved = saveFile(file.toStdString(), asBytes({content.data(), std::size_t(content.size())}));
    return saved ? QString() : engine::reasonText(saved.error().reason());
}

} // namespace skyseal::ui
