#include "ui/map/ground_picture.h"

#include "ui/map/map_painter.h"

#include <QtGui/QPainter>
#include <QtWidgets/QWidget>

namespace skyseal::ui {

GroundPicture::GroundPicture(const TileConfig &tiles, QObject *parent) : QObject(parent), m_tiles(tiles)
{
    connect(&m_tiles, &TileLayer::changed, this, &GroundPicture::markDirty);
    connect(&m_overlays, &OverlayModel::pictureChanged, this, &GroundPicture::markDirty);
}

void GroundPicture::markDirty()
{
    m_dirty = true;
    Q_EMIT changed();
}

const QPixmap &GroundPicture::picture(const Content &content, const QWidget &on)
{
    if (!m_dirty)
        return m_picture;
    m_dirty = false;
    const qreal ratio = on.devicePixelRatioF();
    const QSize wanted = on.size() * ratio;
    if (m_picture.size() != wanted) {
        m_picture = QPixmap(wanted);
        m_picture.setDevicePixelRatio(ratio);
    }
    m_tiles.show(content.viewport);
    const QPalette &palette = on.palette();
    m_picture.fill(palette.color(QPalette::Base));
    QPainter painter(&m_picture);
    painter.setFont(on.font());
    MapPainter(painter, content.map, content.viewport, palette).paintGround(m_tiles, m_overlays, content.fence, content.moving);
    return m_picture;
}

} // namespace skyseal::ui

#include "moc_ground_picture.cpp"
