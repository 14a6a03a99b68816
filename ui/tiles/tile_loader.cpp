#include "ui/tiles/tile_loader.h"

#include "ui/tiles/tile_worker.h"

namespace skyseal::ui {

TileLoader::TileLoader(TileConfig config, QObject *parent) : QObject(parent), m_config(std::move(config))
{
    m_thread.setObjectName(QStringLiteral("tiles"));
}

TileLoader::~TileLoader()
{
    m_thread.quit();
    m_thread.wait();
}

void TileLoader::startThread()
{
    m_worker = new TileWorker(m_config);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(m_worker, &TileWorker::opened, this, [this](int source, const QString &attribution, int deepest) {
        if (source == m_source)
            Q_EMIT opened(attribution, deepest);
    });
    connect(m_worker, &TileWorker::loaded, this, [this](int source, const TileId &tile, const QImage &image) {
        if (source == m_source)
            Q_EMIT loaded(tile, image);
    });
    connect(m_worker, &TileWorker::missing, this, [this](int source, const TileId &tile) {
        if (source == m_source)
            Q_EMIT missing(tile);
    });
    connect(m_worker, &TileWorker::problem, this, [this](int source, const QString &text) {
        if (source == m_source)
            Q_EMIT problem(text);
    });
    connect(m_worker, &TileWorker::regionProgressed, this, &TileLoader::regionProgressed);
    connect(m_worker, &TileWorker::regionEnded, this, &TileLoader::regionEnded);
    m_thread.start(QThread::LowPriority);
}

void TileLoader::setSource(const MapSource &source)
{
    ++m_source;
    if (!m_worker && source.kind == MapSource::Kind::None)
        return;
    if (!m_worker)
        startThread();
    QMetaObject::invokeMethod(m_worker, [worker = m_worker, number = m_source, source] { worker->setSource(number, source); });
}

void TileLoader::request(const QList<TileId> &tiles)
{
    if (m_worker)
        QMetaObject::invokeMethod(m_worker, [worker = m_worker, tiles] { worker->setWanted(tiles); });
}

void TileLoader::fetchRegion(const TileRegion &region, const QString &path)
{
    if (m_worker)
        QMetaObject::invokeMethod(m_worker, [worker = m_worker, region, path] { worker->fetchRegion(region, path); });
}

void TileLoader::cancelRegion()
{
    if (m_worker)
        QMetaObject::invokeMethod(m_worker, [worker = m_worker] { worker->cancelRegion(); });
}

} // namespace skyseal::ui

#include "moc_tile_loader.cpp"
