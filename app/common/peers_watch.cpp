#include "app/common/peers_watch.h"

#include "app/common/output.h"
#include "core/base/json_writer.h"

#include <QtCore/QFileInfo>

#include <sys/stat.h>

namespace skyseal::app {

namespace {

/// Editors write a file in several steps; the file is complete a moment after the first.
constexpr std::chrono::milliseconds kSettle{50};
constexpr std::chrono::seconds kPollEvery{1};
constexpr unsigned kWatchAgainEvery = 60; ///< looks at the file

std::int64_t nanoseconds(const timespec &time)
{
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

} // namespace

PeersWatch::PeersWatch(const std::string &file, Reload reload, QObject *parent)
    : QObject(parent), m_file(QString::fromStdString(file)), m_path(m_file.toLocal8Bit()), m_reload(std::move(reload))
{
    // A change after the stamp was taken is noticed later, even if it comes before the file is read.
    if (const Stamp now = stamp(); m_reload())
        m_seen = now;
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
    m_poller = std::thread([this] { poll(); });
}

PeersWatch::~PeersWatch()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ended = true;
    }
    m_wake.notify_one();
    m_poller.join();
}

/// The poller's thread.
void PeersWatch::poll()
{
    std::unique_lock lock(m_mutex);
    while (!m_wake.wait_for(lock, kPollEvery, [this] { return m_ended; })) {
        lock.unlock();
        const Stamp now = stamp(); // may wait for the disk
        QMetaObject::invokeMethod(
            this, [this, now] { polled(now); }, Qt::QueuedConnection);
        lock.lock();
    }
}

void PeersWatch::polled(const Stamp &now)
{
    const bool isThere = !(now == Stamp());
    const auto isUnwatched = [&] { return m_watcher.directories().isEmpty() || (isThere && m_watcher.files().isEmpty()); };
    // Each attempt writes lines to stderr (Qt). A change of the file is one more.
    if (isUnwatched() && ++m_polls % kWatchAgainEvery == 0)
        keepWatching();
    if (isUnwatched() != m_unwatched) {
        m_unwatched = !m_unwatched;
        Q_EMIT notificationFailed(m_unwatched);
    }
    if (!(now == m_seen) && !m_settle.isActive())
        m_settle.start();
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
    const auto peers = m_reload();
    if (peers) {
        m_seen = now;
        m_problem.clear();
        Q_EMIT reloaded(*peers);
        return;
    }
    // m_seen stays, so that the next look reads the file again.
    std::string problem = peers.error().text();
    if (now == m_refused && problem == m_problem)
        return;
    m_refused = now;
    m_problem = std::move(problem);
    Q_EMIT refused(QString::fromStdString(m_problem));
}

PeersWatch::Stamp PeersWatch::stamp() const
{
    struct stat status
    {};
    if (::stat(m_path.constData(), &status) != 0)
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

std::string peersWatchEvent(bool failed)
{
    JsonWriter line;
    line.beginObject().field("event", "peers_watch").field("notified", !failed).endObject();
    return line.text();
}

std::string peersWatchText(bool failed)
{
    return failed ? "the system does not notify of changes of the list of known peers (are its inotify watches used up?): the "
                    "list is checked once a second"
                  : "the system notifies of changes of the list of known peers again";
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
    QObject::connect(&watch, &PeersWatch::notificationFailed, &watch, [json](bool failed) {
        if (hasRoom(json ? stdout : stderr))
            json ? static_cast<void>(printLine(peersWatchEvent(failed))) : remark(peersWatchText(failed));
    });
    QObject::connect(&watch, &PeersWatch::refused, &watch, [say](const QString &problem) { say(problem.toStdString()); });
}

} // namespace skyseal::app
