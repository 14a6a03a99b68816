#include "app/common/peers_watch.h"

#include "app/common/output.h"
#include "core/base/json_writer.h"

#include <QtCore/QFileInfo>

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>

#include <sys/stat.h>

namespace skyseal::app {

namespace {

/// Editors write a file in several steps: it is read when it has stayed the same for so long.
constexpr std::chrono::milliseconds kSettle{50};
/// The same for a file that was emptied in place: most are about to be written, and an empty list ends every session.
constexpr std::chrono::milliseconds kSettleEmpty{1'000};
constexpr std::chrono::seconds kLookEvery{1};
constexpr unsigned kWatchAgainEvery = 60; ///< looks at the file

/// Detects a change of the file without reading it.
struct Stamp
{
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t modified = 0, changed = 0; ///< ns

    bool operator==(const Stamp &) const = default;
    bool isFile() const { return !(*this == Stamp()); }
};

std::int64_t nanoseconds(const timespec &time)
{
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// All zero if there is no file.
Stamp stampOf(const QByteArray &path)
{
    struct stat status
    {};
    if (::stat(path.constData(), &status) != 0)
        return {};
    return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), nanoseconds(status.st_mtim),
            nanoseconds(status.st_ctim)};
}

} // namespace

/// The result of a look.
struct PeersWatch::Found
{
    bool isFile = false;
    bool changing = false;                                     ///< look again after kSettle
    std::optional<Result<keys::UsablePeers, InputError>> list; ///< to be applied or reported
};

/// The other thread's knowledge of the file.
class PeersWatch::Reader
{
public:
    Reader(const QString &path, Read read, Clock clock)
        : m_path(path.toLocal8Bit()), m_read(std::move(read)), m_clock(std::move(clock))
    {}

    Found look()
    {
        const Stamp stamp = stampOf(m_path);
        Found found{stamp.isFile(), false, {}};
        if (stamp == m_inForce)
            return found;
        const auto now = m_clock();
        const std::optional<Stamp> last = std::exchange(m_last, stamp);
        if (last && !(*last == stamp))
            m_lastSince = now;
        if (last && now - m_lastSince < settleOf(stamp)) {
            found.changing = true;
            return found;
        }
        auto list = m_read();
        if (list) {
            m_inForce = stamp;
            m_problem.clear();
            found.list = std::move(list);
            return found;
        }
        // m_inForce stays, so that the next look reads the file again. The same problem is reported once.
        std::string problem = list.error().text();
        if (stamp == m_refused && problem == m_problem)
            return found;
        m_refused = stamp;
        m_problem = std::move(problem);
        found.list = std::move(list);
        return found;
    }

private:
    std::chrono::milliseconds settleOf(const Stamp &stamp) const
    {
        const bool isEmptied = stamp.size == 0 && m_inForce && m_inForce->size > 0 && m_inForce->inode == stamp.inode;
        return isEmptied && stamp.isFile() ? kSettleEmpty : kSettle;
    }

    const QByteArray m_path;
    const Read m_read;
    const Clock m_clock;
    std::optional<Stamp> m_inForce;                    ///< of the file that is in force; nullopt if it is not known
    std::optional<Stamp> m_last;                       ///< of the last look
    std::chrono::steady_clock::time_point m_lastSince; ///< when a look found it first
    Stamp m_refused;                                   ///< of the file that was refused last
    std::string m_problem;                             ///< of that file
};

PeersWatch::PeersWatch(const std::string &file, Apply apply, QObject *parent)
    : PeersWatch(
        file, [file] { return keys::readPeers(file); }, std::move(apply), &std::chrono::steady_clock::now, parent)
{}

PeersWatch::PeersWatch(const std::string &file, Read read, Apply apply, Clock clock, QObject *parent)
    : QObject(parent), m_file(QString::fromStdString(file)), m_apply(std::move(apply)),
      m_reader(std::make_shared<Reader>(m_file, std::move(read), std::move(clock)))
{
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettle);
    connect(&m_settle, &QTimer::timeout, this, &PeersWatch::look);
    connect(&m_everySecond, &QTimer::timeout, this, &PeersWatch::look);
    // Watch the folder as well, since most programs replace a file instead of writing into it.
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &PeersWatch::look);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &PeersWatch::look);
    keepWatching();
    m_everySecond.start(kLookEvery);
    look();
}

PeersWatch::~PeersWatch() = default;

void PeersWatch::look()
{
    if (m_looking) {
        m_lookAgain = true;
        checkDisk();
        return;
    }
    m_looking = true;
    m_lookBegan.start();
    m_files.run(
        this, [reader = m_reader] { return reader->look(); }, [this](Found found) { take(std::move(found)); });
}

void PeersWatch::checkDisk()
{
    if (m_slow || !m_lookBegan.hasExpired(std::chrono::milliseconds(kSlow).count()))
        return;
    m_slow = true;
    Q_EMIT refused(InputError{sentence("Reason", "the disk does not answer"), m_file.toStdString()}.reason());
}

void PeersWatch::take(Found found)
{
    m_looking = m_slow = false;
    // The first list is the one that the program has read, as a rule.
    const bool isFirst = std::exchange(m_first, false);
    const auto isUnwatched = [&] { return m_watcher.directories().isEmpty() || (found.isFile && m_watcher.files().isEmpty()); };
    // Each attempt writes lines to stderr (Qt). A change of the file is one more.
    if (found.changing || found.list || (isUnwatched() && ++m_looks % kWatchAgainEvery == 0))
        keepWatching();
    if (isUnwatched() != m_unwatched) {
        m_unwatched = !m_unwatched;
        Q_EMIT notificationFailed(m_unwatched);
    }
    if (std::exchange(m_lookAgain, false) || found.changing)
        m_settle.start();
    if (!found.list)
        return;
    if (!*found.list) {
        Q_EMIT refused(found.list->error().reason());
        return;
    }
    keys::UsablePeers &list = **found.list;
    const keys::PeersInForce inForce = list.inForce();
    m_apply(std::move(list.peers));
    if (!isFirst)
        Q_EMIT reloaded(inForce);
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

std::string peersEvent(const keys::PeersInForce &peers)
{
    JsonWriter line;
    line.beginObject().field("event", "peers").field("count", std::uint64_t{peers.count});
    if (!peers.leftOut.empty())
        line.field("problem", peers.leftOut.text());
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
        + (peers.leftOut.empty() ? "" : "; left out: " + peers.leftOut.text());
}

std::string peersText(const std::string &problem)
{
    return "the list of known peers cannot be used, the previous one stays in force: " + problem;
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

void reportPeers(const PeersWatch &watch, bool json)
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
    QObject::connect(&watch, &PeersWatch::refused, &watch, [say](const Reason &problem) { say(problem.text()); });
}

} // namespace skyseal::app

#include "moc_peers_watch.cpp"
