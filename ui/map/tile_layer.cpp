#include "ui/map/tile_layer.h"

#include <cstdlib>

namespace skyseal::ui {

namespace {
constexpr int kMostMissing = 10'000; ///< tiles that are remembered as missing
} // namespace

TileLayer::TileLayer(TileConfig config, QObject *parent) : QObject(parent), m_loader(std::move(config)), m_kept(kKeptKilobytes)
{
    connect(&m_loader, &TileLoader::opened, this, [this](const QString &attribution, int deepest) {
        m_attribution = attribution;
        m_deepest = deepest;
        Q_EMIT changed();
    });
    connect(&m_loader, &TileLoader::loaded, this, &TileLayer::keep);
    connect(&m_loader, &TileLoader::missing, this, [this](const TileId &tile) {
        if (m_missing.size() >= kMostMissing)
            m_missing.clear();
        m_missing.insert(tile);
    });
    connect(&m_loader, &TileLoader::problem, this, [this](const QString &text) {
        m_problem = text;
        Q_EMIT changed();
    });
}

void TileLayer::setSource(const MapSource &source)
{
    if (source == m_source)
        return;
    m_source = source;
    m_attribution.clear();
    m_problem.clear();
    m_deepest = source.kind == MapSource::Kind::Server ? source.deepest : TileId::kDeepest;
    m_kept.clear();
    m_missing.clear();
    m_requested.clear();
    m_loader.setSource(source);
    Q_EMIT changed();
}

void TileLayer::keep(const TileId &tile, const QImage &image)
{
    m_kept.insert(tile, new QImage(image), std::max<qsizetype>(1, image.sizeInBytes() / 1024));
    m_requested.removeOne(tile);
    Q_EMIT changed();
}

void TileLayer::show(const MapViewport &viewport)
{
    if (!isOn())
        return;
    m_range = tilesIn(viewport.visible(), std::clamp(qRound(viewport.zoomLevel()), 0, m_deepest));
    // The visible tiles must fit, or they would be loaded again and again.
    constexpr qsizetype kTileKilobytes = 256;
    m_kept.setMaxCost(std::max<qsizetype>(kKeptKilobytes, 3 * m_range.count() * kTileKilobytes / 2));
    QList<TileId> lacking;
    for (int row = m_range.top; row <= m_range.bottom; ++row) {
        for (int column = m_range.left; column <= m_range.right; ++column) {
            const TileId tile = m_range.at(column, row);
            if (!m_kept.contains(tile) && !m_missing.contains(tile) && !lacking.contains(tile))
                lacking << tile;
        }
    }
    const int middleRow = (m_range.top + m_range.bottom) / 2, middle = m_range.at((m_range.left + m_range.right) / 2, 0).column;
    const auto far = [&](const TileId &tile) { return std::abs(tile.row - middleRow) + std::abs(tile.column - middle); };
    std::stable_sort(lacking.begin(), lacking.end(), [&](const TileId &a, const TileId &b) { return far(a) < far(b); });
    if (lacking == m_requested)
        return;
    m_requested = lacking;
    m_loader.request(lacking);
}

} // namespace skyseal::ui

#include "moc_tile_layer.cpp"
