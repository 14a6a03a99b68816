#include "app/common/peers_watch.h"

#include "app/common/output.h"
#include "core/base/json_writer.h"

#include <QtCore/QFileInfo>

#include <sys/stat.h>

namespace skyseal::app {

namespace {

/// Editors write a file in several steps; the file is complete a moment after the first.
constexpr std::chrono::milliseconds kSettle{50};

std::int64_t nanoseconds(const timespec &time)
{
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

} // namespace

PeersWatch::PeersWatch(const std::string &file, Reload reload, QObject *parent)
    : QObject(parent), m_file(QString::fromStdString(file)), m_reload(std::move(reload)), m_seen(stamp())
{
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettle);
    connect(&m_settle, &QTimer::timeout, this, &PeersWatch::look);
    // Watch the folder as well, since most programs replace a file instead of writing into it.
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] {
        if (!m_settle.isActive() && !(stamp() == m_seen))
            m_settle.start();
    });
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] {
        if (!m_settle.isActive())
            m_settle.start();
    });
    keepWatching();
}

void PeersWatch::keepWatching()
{
    const QString folder = QFileInfo(m_file).absolutePath();
    if (!m_watcher.directories().contains(folder))
        m_watcher.addPath(folder);
    // After a replacement the watch on the old file is gone, or refers to the deleted file.
    m_watcher.removePath(m_file);
    if (QFileInfo::exists(m_file))
        m_watcher.addPath(m_file);
}

void PeersWatch::look()
{
    keepWatching();
    const Stamp now = stamp();
    if (now == m_seen)
        return;
    m_seen = now;
    const auto peers = m_reload();
    if (peers)
        Q_EMIT reloaded(*peers);
    else
        Q_EMIT refused(QString::fromStdString(peers.error().text()));
}

PeersWatch::Stamp PeersWatch::stamp() const
{
    struct stat status
    {};
    if (::stat(m_file.toLocal8Bit().constData(), &status) != 0)
        return {};
    return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), nanoseconds(status.st_mtim),
            nanoseconds(status.st_ctim)};
}

std::string peersEvent(const keys::PeersInForce &peers)
{
    JsonWriter line;
    line.beginObject().field("event", "peers").field("count", std::uint64_t{peers.count});
    if (!peers.leftOut.empty())
        line.field("problem", peers.leftOut);
    line.endObject();
    return line.text();
}

std::string peersEvent(const std::string &problem)
{
    JsonWriter line;
    line.beginObject().field("event", "peers").field("problem", problem).endObject();
    return line.text();
}

std::string peersText(const keys::PeersInForce &peers)
{
    return "the list of known peers was changed: " + std::to_string(peers.count) + (peers.count == 1 ? " peer" : " peers")
        + (peers.leftOut.empty() ? "" : "; left out: " + peers.leftOut);
}

std::string peersText(const std::string &problem)
{
    return "the changed list of known peers is invalid, the previous one stays in force: " + problem;
}

void tellPeers(const PeersWatch &watch, bool json)
{
    const auto say = [json](const auto &what) {
        if (!hasRoom(json ? stdout : stderr))
            return;
        if (json)
            printLine(peersEvent(what));
        else
            remark(peersText(what));
    };
    QObject::connect(&watch, &PeersWatch::reloaded, &watch, say);
    QObject::connect(&watch, &PeersWatch::refused, &watch, [say](const QString &problem) { say(problem.toStdString()); });
}

} // namespace skyseal::app
