#include "ui/tiles/region_fetch.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct RegionFetchText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::RegionFetch)
};

/// As MBTiles writes bounds: left, bottom, right, top.
QString boundsText(const QRectF &metres)
{
    const LatLong southWest = mercator::unproject(metres.topLeft()), northEast = mercator::unproject(metres.bottomRight());
    return QStringLiteral("%1,%2,%3,%4")
        .arg(southWest.longitude, 0, 'f', 6)
        .arg(southWest.latitude, 0, 'f', 6)
        .arg(northEast.longitude, 0, 'f', 6)
        .arg(northEast.latitude, 0, 'f', 6);
}

} // namespace

Result<std::unique_ptr<RegionFetch>, QString> RegionFetch::begin(const TileRegion &region, const QString &path)
{
    auto writer = MbtilesWriter::create(path);
    if (!writer)
        return tl::unexpected(writer.error());
    return std::unique_ptr<RegionFetch>(new RegionFetch(region, path, std::move(*writer)));
}

std::optional<RegionFetch::Job> RegionFetch::next()
{
    if (const auto tile = m_walk.next())
        return Job{*tile};
    if (m_again.empty())
        return std::nullopt;
    const Job out = m_again.back();
    m_again.pop_back();
    return out;
}

Result<void, QString> RegionFetch::tileArrived(const Job &job, const QByteArray &bytes)
{
    if (auto written = m_writer->add(job.tile, bytes); !written)
        return written;
    m_format = tileFormatOf(bytes);
    ++m_progress.done;
    m_progress.bytes += bytes.size();
    m_failedInARow = 0;
    return {};
}

void RegionFetch::tileMissing()
{
    ++m_progress.done;
    m_failedInARow = 0;
}

void RegionFetch::tileFailed(Job job)
{
    ++m_failedInARow;
    if (++job.attempts < kAttempts)
        m_again.push_back(job);
    else
        ++m_progress.failed;
}

Result<QString, QString> RegionFetch::finish(const QString &name, const QString &attribution)
{
    if (m_progress.bytes == 0)
        return tl::unexpected(RegionFetchText::tr("the server has no tiles there"));
    const auto done = m_writer->finish({{QStringLiteral("name"), name},
                                        {QStringLiteral("format"), formatName(m_format)},
                                        {QStringLiteral("type"), QStringLiteral("baselayer")},
                                        {QStringLiteral("attribution"), attribution},
                                        {QStringLiteral("bounds"), boundsText(m_region.metres)},
                                        {QStringLiteral("minzoom"), QString::number(m_region.shallowest)},
                                        {QStringLiteral("maxzoom"), QString::number(m_region.deepest)}});
    if (!done)
        return tl::unexpected(done.error());
    return m_path;
}

} // namespace skyseal::ui
