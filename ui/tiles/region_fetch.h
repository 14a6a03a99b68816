// A region that is being fetched into an MBTiles file: which tiles are still to be requested, and what has come of the others.
#pragma once

#include "ui/tiles/mbtiles_writer.h"
#include "ui/tiles/tile_image.h"
#include "ui/tiles/tile_range.h"

#include <memory>
#include <vector>

namespace skyseal::ui {

struct RegionProgress
{
    qint64 done = 0, total = 0; ///< tiles; those that the server does not have count as done
    qint64 bytes = 0;
    qint64 failed = 0; ///< tiles that could not be fetched
};

/// How a region ended: the file is complete, or there is none.
struct RegionEnd
{
    QString file;    ///< empty unless complete
    QString problem; ///< for people; empty if complete or cancelled
    RegionProgress progress;
};

/// To be used in one thread at a time.
class RegionFetch
{
public:
    static constexpr int kAttempts = 3;       ///< for each tile
    static constexpr int kFailuresToEnd = 10; ///< requests in a row

    struct Job
    {
        TileId tile;
        int attempts = 0;
    };

    static Result<std::unique_ptr<RegionFetch>, QString> begin(const TileRegion &region, const QString &path);

    /// The next tile to request; nullopt if all have been requested.
    std::optional<Job> next();
    Result<void, QString> tileArrived(const Job &job, const QByteArray &bytes);
    void tileMissing();
    /// Requests it again later, a limited number of times.
    void tileFailed(Job job);
    bool isComplete() const { return m_progress.done + m_progress.failed == m_progress.total; }
    bool isHopeless() const { return m_failedInARow >= kFailuresToEnd; }
    const RegionProgress &progress() const { return m_progress; }
    /// Gives the file its name. Fails if not one tile has come.
    Result<QString, QString> finish(const QString &name, const QString &attribution);

private:
    RegionFetch(const TileRegion &region, QString path, std::unique_ptr<MbtilesWriter> writer)
        : m_region(region), m_path(std::move(path)), m_writer(std::move(writer)), m_walk(region)
    {
        m_progress.total = region.count();
    }

    TileRegion m_region;
    QString m_path;
    std::unique_ptr<MbtilesWriter> m_writer;
    RegionWalk m_walk;
    std::vector<Job> m_again;
    RegionProgress m_progress;
    TileFormat m_format = TileFormat::Unknown;
    int m_failedInARow = 0;
};

} // namespace skyseal::ui
