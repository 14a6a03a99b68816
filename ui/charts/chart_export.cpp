#include "ui/charts/chart_export.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QSaveFile>
#include <QtGui/QImageWriter>
#include <QtGui/QPainter>
#include <QtSvg/QSvgGenerator>
#include <QtWidgets/QWidget>

#include <algorithm>

namespace skyseal::ui {

namespace {

/// The translation context of the functions below.
struct Text
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

QString writeSvg(const QString &file, const std::vector<QWidget *> &parts, const QSize &size)
{
    QSaveFile out(file);
    if (!out.open(QIODevice::WriteOnly))
        return out.errorString();
    QSvgGenerator generator;
    generator.setOutputDevice(&out);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(Text::tr("Skyseal diagnostics"));
    QPainter painter(&generator);
    paintAll(painter, parts, size);
    painter.end();
    return out.commit() ? QString() : out.errorString();
}

} // namespace

QString writePicture(const QString &file, const std::vector<QWidget *> &parts)
{
    QSize size;
    for (const QWidget *part : parts)
        size = {std::max(size.width(), part->width()), size.height() + part->height()};
    if (file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive))
        return writeSvg(file, parts, size);
    constexpr int kScale = 2;
    QImage image(size * kScale, QImage::Format_RGB32);
    image.setDevicePixelRatio(kScale);
    QPainter painter(&image);
    paintAll(painter, parts, size);
    painter.end();
    QImageWriter writer(file);
    return writer.write(image) ? QString() : writer.errorString();
}

QString writeWhole(const QString &file, const QByteArray &content)
{
    QSaveFile out(file);
    if (!out.open(QIODevice::WriteOnly))
        return out.errorString();
    out.write(content);
    return out.commit() ? QString() : out.errorString();
}

} // namespace skyseal::ui
