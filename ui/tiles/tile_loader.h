// The window's side of the tiles: passes wishes to TileWorker in its thread and reports what comes of them. The thread starts
// with the first source. Lives on the GUI thread.
#pragma once

#include "ui/settings.h"
#include "ui/tiles/region_fetch.h"
#include "ui/tiles/tile_config.h"

#include <QtCore/QList>
#include <QtCore/QObject>
#include <QtCore/QThread>
#include <QtGui/QImage>

namespace skyseal::ui {

class TileWorker;

class TileLoader : public QObject
{
    Q_OBJECT

public:
    explicit TileLoader(TileConfig config, QObject *parent = nullptr);
    ~TileLoader() override;

    void setSource(const MapSource &source);
    /// Replaces the tiles that wait to be loaded: the most wanted one first.
    void request(const QList<TileId> &tiles);
    /// Fetches from the server in use, into an MBTiles file.
    void fetchRegion(const TileRegion &region, const QString &path);
    void cancelRegion();

Q_SIGNALS:
    void opened(const QString &attribution, int deepest);
    void loaded(const skyseal::ui::TileId &tile, const QImage &image);
    void missing(const skyseal::ui::TileId &tile);
    /// For people; empty once there is none any more.
    void problem(const QString &text);
    void regionProgressed(const skyseal::ui::RegionProgress &progress);
    void regionEnded(const skyseal::ui::RegionEnd &end);

private:
    void startThread();

    TileConfig m_config;
    QThread m_thread;
    TileWorker *m_worker = nullptr; ///< deletes itself at the end of the thread
    int m_source = 0;               ///< number of the source; results of earlier ones are dropped
};

} // namespace skyseal::ui
