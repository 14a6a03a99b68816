// Loads and decodes tiles in a thread of its own, from a server or from a file, and fetches regions. Nothing is
// requested of a server before setSource() names it.
#pragma once

#include "ui/settings.h"
#include "ui/tiles/region_fetch.h"
#include "ui/tiles/tile_config.h"
#include "ui/tiles/tile_file.h"
#include "ui/tiles/tile_template.h"

#include <QtCore/QHash>
#include <QtCore/QList>
#include <QtCore/QObject>
#include <QtCore/QTimer>
#include <QtGui/QImage>

#include <memory>
#include <optional>

class QNetworkAccessManager;
class QNetworkReply;

namespace skyseal::ui {

/// Lives in the thread of TileLoader, which calls it by queued invocations and receives its signals queued. `source` in the
/// signals is the number given to setSource().
class TileWorker : public QObject
{
    Q_OBJECT

public:
    static constexpr int kConnections = 2; ///< at most, to one server

    explicit TileWorker(TileConfig config);
    ~TileWorker() override;

    void setSource(int number, const MapSource &source);
    /// Replaces the tiles that wait for their request: the most wanted one first.
    void setWanted(const QList<TileId> &tiles);
    void fetchRegion(const TileRegion &region, const QString &path);
    void cancelRegion();

Q_SIGNALS:
    /// The source can be used. Of a file: what it says of itself; of a server, what the operator entered.
    void opened(int source, const QString &attribution, int deepest);
    void loaded(int source, const skyseal::ui::TileId &tile, const QImage &image);
    /// The source has no such tile, or one that cannot be shown.
    void missing(int source, const skyseal::ui::TileId &tile);
    /// For people: why tiles do not come; empty once they do again.
    void problem(int source, const QString &text);
    void regionProgressed(const skyseal::ui::RegionProgress &progress);
    void regionEnded(const skyseal::ui::RegionEnd &end);

private:
    struct Running
    {
        TileId tile;
        std::optional<RegionFetch::Job> region;
        bool oversized = false;
    };

    void work();
    void loadFromFile();
    void startRequests();
    void start(const TileId &tile, std::optional<RegionFetch::Job> region);
    /// Ends requests without a word of them.
    template<typename Predicate> void drop(Predicate matches);
    void finished(QNetworkReply *reply);
    void arrived(const Running &job, const QByteArray &bytes);
    void absent(const Running &job);
    void failed(const Running &job, const QString &why);
    QByteArray fromCache(const QUrl &url) const;
    void reportProblem(const QString &problem);
    void endRegionIfDone();
    void endRegion(const RegionEnd &end);

    TileConfig m_config;
    MapSource m_source;
    int m_number = 0;
    std::optional<TileFile> m_file;
    std::optional<TileTemplate> m_server;
    QNetworkAccessManager *m_network = nullptr; ///< made for the first server
    QList<TileId> m_wanted;
    QHash<QNetworkReply *, Running> m_running;
    std::unique_ptr<RegionFetch> m_region;
    QTimer m_pause; ///< after a failure
    int m_pauseMs = 0;
    QString m_problem;
};

} // namespace skyseal::ui
