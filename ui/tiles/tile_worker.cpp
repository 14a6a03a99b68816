#include "ui/tiles/tile_worker.h"

#include "ui/tiles/tile_image.h"

#include <QtNetwork/QNetworkAccessManager>
#include <QtNetwork/QNetworkDiskCache>
#include <QtNetwork/QNetworkReply>

#include <algorithm>
#include <utility>

namespace skyseal::ui {

namespace {
constexpr int kTransferTimeoutMs = 15'000;
constexpr int kLongestPauseMs = 60'000;
} // namespace

TileWorker::TileWorker(TileConfig config) : m_config(std::move(config)), m_pause(this)
{
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &TileWorker::work);
}

TileWorker::~TileWorker() = default;

template<typename Predicate> void TileWorker::drop(Predicate matches)
{
    for (auto job = m_running.begin(); job != m_running.end();) {
        if (!matches(*job)) {
            ++job;
            continue;
        }
        QNetworkReply *reply = job.key();
        job = m_running.erase(job);
        reply->disconnect(this);
        reply->abort();
        reply->deleteLater();
    }
}

void TileWorker::setSource(int number, const MapSource &source)
{
    m_number = number;
    m_source = source;
    m_wanted.clear();
    m_file.reset();
    m_server.reset();
    m_problem.clear();
    m_pause.stop();
    m_pauseMs = 0;
    if (m_region)
        endRegion({{}, tr("the source of the map was changed"), m_region->progress()});
    drop([](const Running &) { return true; });
    if (source.kind == MapSource::Kind::File) {
        auto file = TileFile::open(source.file);
        if (!file)
            return reportProblem(file.error());
        m_file.emplace(std::move(*file));
        Q_EMIT opened(m_number, m_file->facts().attribution, m_file->facts().deepest);
    } else if (source.kind == MapSource::Kind::Server) {
        auto server = TileTemplate::parse(source.url);
        if (!server)
            return reportProblem(server.error());
        m_server.emplace(std::move(*server));
        Q_EMIT opened(m_number, source.attribution, source.deepest);
    }
}

void TileWorker::setWanted(const QList<TileId> &tiles)
{
    m_wanted.clear();
    for (const TileId &tile : tiles) {
        const bool running = std::any_of(m_running.cbegin(), m_running.cend(),
                                         [&](const Running &job) { return !job.region && job.tile == tile; });
        if (tile.exists() && !running)
            m_wanted << tile;
    }
    work();
}

void TileWorker::work()
{
    if (m_file)
        loadFromFile();
    else if (m_server && !m_pause.isActive())
        startRequests();
}

/// One tile, so that newer wishes are heard between two.
void TileWorker::loadFromFile()
{
    if (m_wanted.isEmpty())
        return;
    const Running job{m_wanted.takeFirst(), {}, false};
    const auto bytes = m_file->tile(job.tile);
    if (!bytes) {
        reportProblem(bytes.error());
        Q_EMIT missing(m_number, job.tile);
    } else if (!*bytes) {
        absent(job);
    } else {
        arrived(job, **bytes);
    }
    QMetaObject::invokeMethod(this, &TileWorker::work, Qt::QueuedConnection);
}

void TileWorker::startRequests()
{
    while (m_running.size() < kConnections) {
        if (!m_wanted.isEmpty()) { // what is looked at comes before what is fetched for later
            start(m_wanted.takeFirst(), {});
            continue;
        }
        const auto job = m_region ? m_region->next() : std::nullopt;
        if (!job)
            break;
        start(job->tile, job);
    }
    endRegionIfDone();
}

void TileWorker::start(const TileId &tile, std::optional<RegionFetch::Job> region)
{
    if (!m_network) {
        m_network = new QNetworkAccessManager(this);
        m_network->setTransferTimeout(kTransferTimeoutMs);
        if (!m_config.cacheFolder.isEmpty()) {
            auto *cache = new QNetworkDiskCache(m_network);
            cache->setCacheDirectory(m_config.cacheFolder);
            cache->setMaximumCacheSize(m_config.cacheBytes);
            m_network->setCache(cache);
        }
    }
    QNetworkRequest request(m_server->urlOf(tile));
    request.setHeader(QNetworkRequest::UserAgentHeader, m_config.userAgent);
    request.setRawHeader("Accept", "image/png, image/jpeg, image/webp");
    request.setRawHeader("Accept-Encoding", "identity"); // a compressed answer could grow beyond every limit
    request.setAttribute(QNetworkRequest::CacheLoadControlAttribute, QNetworkRequest::PreferCache);
    request.setAttribute(QNetworkRequest::CookieLoadControlAttribute, QNetworkRequest::Manual);
    request.setAttribute(QNetworkRequest::CookieSaveControlAttribute, QNetworkRequest::Manual);
    request.setAttribute(QNetworkRequest::AuthenticationReuseAttribute, QNetworkRequest::Manual);
    // Only the server that the operator chose learns where the map is looked at.
    request.setAttribute(QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::SameOriginRedirectPolicy);
    request.setMaximumRedirectsAllowed(3);
    QNetworkReply *reply = m_network->get(request);
    m_running.insert(reply, {tile, region, false});
    connect(reply, &QNetworkReply::readyRead, this, [this, reply] {
        const auto job = m_running.find(reply);
        if (job == m_running.end() || reply->bytesAvailable() <= kLargestTile)
            return;
        job->oversized = true;
        reply->abort();
    });
    connect(reply, &QNetworkReply::finished, this, [this, reply] { finished(reply); });
}

void TileWorker::finished(QNetworkReply *reply)
{
    reply->deleteLater();
    const Running job = m_running.take(reply);
    const int status = reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
    if (job.oversized) {
        reportProblem(tr("a tile is larger than %1 kB").arg(kLargestTile / 1024));
        absent(job);
    } else if (reply->error() == QNetworkReply::OperationCanceledError) { // by the time-out
        failed(job, tr("the server does not answer"));
    } else if (status == 404 || status == 410 || status == 204) {
        absent(job);
    } else if (reply->error() != QNetworkReply::NoError) {
        const QByteArray kept = fromCache(reply->url());
        if (kept.isEmpty())
            failed(job, tr("no tile could be downloaded: %1").arg(reply->errorString()));
        else
            arrived(job, kept);
    } else {
        m_pauseMs = 0;
        arrived(job, reply->readAll());
    }
    work();
}

/// The server's last answer, however old, while the server does not answer.
QByteArray TileWorker::fromCache(const QUrl &url) const
{
    if (!m_network->cache())
        return {};
    const std::unique_ptr<QIODevice> kept(m_network->cache()->data(url));
    return kept ? kept->read(kLargestTile + 1) : QByteArray();
}

void TileWorker::arrived(const Running &job, const QByteArray &bytes)
{
    const auto image = decodeTile(bytes);
    if (!image) {
        reportProblem(image.error());
        return absent(job);
    }
    if (!job.region) {
        reportProblem({});
        Q_EMIT loaded(m_number, job.tile, *image);
    } else if (m_region) {
        if (const auto written = m_region->tileArrived(*job.region, bytes); !written)
            return endRegion({{}, written.error(), m_region->progress()});
        Q_EMIT regionProgressed(m_region->progress());
    }
}

void TileWorker::absent(const Running &job)
{
    if (!job.region) {
        Q_EMIT missing(m_number, job.tile);
    } else if (m_region) {
        m_region->tileMissing();
        Q_EMIT regionProgressed(m_region->progress());
    }
}

void TileWorker::failed(const Running &job, const QString &why)
{
    if (!m_pause.isActive()) { // one of the requests under way has begun it
        m_pauseMs = std::clamp(2 * m_pauseMs, m_config.pauseMs, kLongestPauseMs);
        m_pause.start(m_pauseMs);
    }
    reportProblem(why);
    if (!job.region) {
        m_wanted << job.tile; // again, unless it is no longer looked at by then
        return;
    }
    if (!m_region)
        return;
    m_region->tileFailed(*job.region);
    Q_EMIT regionProgressed(m_region->progress());
    if (m_region->isHopeless())
        endRegion({{}, why, m_region->progress()});
    else
        endRegionIfDone();
}

void TileWorker::reportProblem(const QString &problemText)
{
    if (problemText == m_problem)
        return;
    m_problem = problemText;
    Q_EMIT problem(m_number, problemText);
}

void TileWorker::fetchRegion(const TileRegion &region, const QString &path)
{
    cancelRegion();
    if (!m_server)
        return endRegion({{}, tr("the map has no tile server"), {}});
    if (const QString forbidden = m_server->offlineForbiddenReason(); !forbidden.isEmpty())
        return endRegion({{}, forbidden, {}});
    auto fetch = RegionFetch::begin(region, path);
    if (!fetch)
        return endRegion({{}, fetch.error(), {}});
    m_region = std::move(*fetch);
    Q_EMIT regionProgressed(m_region->progress());
    work();
}

void TileWorker::cancelRegion()
{
    if (m_region)
        endRegion({{}, {}, m_region->progress()});
}

void TileWorker::endRegionIfDone()
{
    if (!m_region || !m_region->isComplete())
        return;
    const RegionProgress progress = m_region->progress();
    const auto file = m_region->finish(m_server->host(), m_source.attribution);
    endRegion(file ? RegionEnd{*file, {}, progress} : RegionEnd{{}, file.error(), progress});
}

void TileWorker::endRegion(const RegionEnd &end)
{
    drop([](const Running &job) { return job.region.has_value(); });
    m_region.reset(); // removes an incomplete file
    Q_EMIT regionEnded(end);
}

} // namespace skyseal::ui

#include "moc_tile_worker.cpp"
