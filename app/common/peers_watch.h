// Watches the file of known peers while a program runs, so that the session of a removed peer ends at once. The system's
// notification (inotify) acts within a tenth of a second; where it fails, or a network file system delivers nothing, a look at
// the file once a second does. An invalid edit is reported, and the previous list stays in force.
#pragma once

#include "core/base/result.h"
#include "core/keys/peers_file.h"

#include <QtCore/QFileSystemWatcher>
#include <QtCore/QObject>
#include <QtCore/QTimer>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace skyseal::app {

/// Lives on the thread of its event loop, which must not wait for a disk that hangs: a thread of its own looks at the file.
class PeersWatch : public QObject
{
    Q_OBJECT

public:
    /// Callback that reads the file and applies it; returns the result or the reason for refusing it.
    using Reload = std::function<Result<keys::PeersInForce, InputError>()>;

    /// Calls `reload` once: the list may have changed since the program read it. Its failure is reported later, by refused().
    PeersWatch(const std::string &file, Reload reload, QObject *parent = nullptr);
    ~PeersWatch() override;

Q_SIGNALS:
    void reloaded(const skyseal::keys::PeersInForce &peers);
    /// `problem`: a sentence for the user. Reading is tried again each second, and reported again for another change or problem.
    void refused(const QString &problem);
    /// The system does not notify of changes: they take effect up to a second later. `false`: it does again.
    void notificationFailed(bool failed);

private:
    /// Detects a change of the file without reading it.
    struct Stamp
    {
        std::uint64_t device = 0, inode = 0, size = 0;
        std::int64_t modified = 0, changed = 0; ///< ns
        bool operator==(const Stamp &) const = default;
    };

    void look();
    void keepWatching();
    void poll();
    void polled(const Stamp &now);
    Stamp stamp() const;

    QString m_file;
    const QByteArray m_path; ///< m_file for system calls
    Reload m_reload;
    QFileSystemWatcher m_watcher;
    QTimer m_settle;
    std::optional<Stamp> m_seen; ///< of the file that is in force; nullopt if that is another one
    Stamp m_refused;             ///< of the file that was refused last
    std::string m_problem;       ///< of that file
    bool m_unwatched = false;    ///< the system does not notify
    unsigned m_polls = 0;        ///< while it does not
    std::mutex m_mutex;          ///< of m_ended
    std::condition_variable m_wake;
    bool m_ended = false;
    std::thread m_poller;
};

/// {"event":"peers","count":…}, with a "problem" if a peer is excluded, and {"event":"peers","problem":…}
std::string peersEvent(const keys::PeersInForce &peers);
std::string peersEvent(const std::string &problem);
/// The same as text.
std::string peersText(const keys::PeersInForce &peers);
std::string peersText(const std::string &problem);

/// {"event":"peers_watch","notified":…}
std::string peersWatchEvent(bool failed);
std::string peersWatchText(bool failed);

/// Reports the results of the watch on stdout (with `json`) or stderr.
void tellPeers(const PeersWatch &watch, bool json);

} // namespace skyseal::app
