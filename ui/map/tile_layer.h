// The pictures under the map: which tiles are there, and which have to be loaded. Keeps the ones used last, within a limit.
// Lives on the GUI thread.
#pragma once

#include "ui/map/map_viewport.h"
#include "ui/tiles/tile_loader.h"
#include "ui/tiles/tile_range.h"

#include <QtCore/QCache>
#include <QtCore/QObject>
#include <QtCore/QSet>

namespace skyseal::ui {

class TileLayer : public QObject
{
    Q_OBJECT

public:
    /// Kilobytes of decoded tiles that are kept, unless the picture itself needs more: 128 tiles of 256×256 pixels.
    static constexpr int kKeptKilobytes = 32 * 1024;

    explicit TileLayer(TileConfig config, QObject *parent = nullptr);

    void setSource(const MapSource &source);
    const MapSource &source() const { return m_source; }
    bool isOn() const { return m_source.kind != MapSource::Kind::None; }

    /// Requests what this picture needs and lacks; to be called for each new viewport.
    void show(const MapViewport &viewport);
    /// The tiles of the picture; rows and columns at their level.
    const TileRange &range() const { return m_range; }
    /// Null if it is not there. Counts as used.
    const QImage *find(const TileId &tile) const { return m_kept.object(tile); }

    const QString &attribution() const { return m_attribution; }
    const QString &problem() const { return m_problem; }
    int deepest() const { return m_deepest; }
    TileLoader &loader() { return m_loader; }
    qsizetype keptKilobytes() const { return m_kept.totalCost(); }

Q_SIGNALS:
    /// The picture has changed.
    void changed();

private:
    void keep(const TileId &tile, const QImage &image);

    TileLoader m_loader;
    MapSource m_source;
    QString m_attribution, m_problem;
    int m_deepest = TileId::kDeepest;
    QCache<TileId, QImage> m_kept;
    QSet<TileId> m_missing;
    TileRange m_range;
    QList<TileId> m_requested;
};

} // namespace skyseal::ui
