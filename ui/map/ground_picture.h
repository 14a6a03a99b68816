// A picture of the ground: tiles or a graticule, overlays, fence, mission, track. It is painted again only when it shows
// something else, so that a moving vehicle costs little. Lives on the GUI thread.
#pragma once

#include "ui/map/tile_layer.h"
#include "ui/overlays/overlay_model.h"

#include <QtCore/QObject>
#include <QtGui/QPixmap>

class QWidget;

namespace skyseal::ui {

class FenceContent;
class MapContent;
class MapViewport;

class GroundPicture : public QObject
{
    Q_OBJECT

public:
    explicit GroundPicture(const TileConfig &tiles, QObject *parent = nullptr);

    struct Content
    {
        const MapContent &map;
        const FenceContent &fence;
        const MapViewport &viewport;
        bool moving; ///< painted quickly rather than finely
    };

    TileLayer &tiles() { return m_tiles; }
    OverlayModel &overlays() { return m_overlays; }
    bool isDirty() const { return m_dirty; }
    /// Something of the content has changed.
    void markDirty();
    /// In the size, colors and font of this widget; painted again if it is dirty.
    const QPixmap &picture(const Content &content, const QWidget &on);

Q_SIGNALS:
    /// The picture is dirty.
    void changed();

private:
    TileLayer m_tiles;
    OverlayModel m_overlays;
    QPixmap m_picture;
    bool m_dirty = true;
};

} // namespace skyseal::ui
