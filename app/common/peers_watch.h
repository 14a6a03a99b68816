// Watches the file of known peers while a program runs, so that the session of a removed peer ends at once. The system's
// notification (inotify) acts within a tenth of a second; where it fails, or a network file system delivers nothing, a look at
// the file once a second does. An invalid edit is reported, and the previous list stays in force.
#pragma once

#include "core/base/result.h"
#include "core/engine/common/file_thread.h"
#include "core/keys/usable_peers.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QFileSystemWatcher>
#include <QtCore/QObject>
#include <QtCore/QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace skyseal::app {

/// Lives on the thread of its event loop, which must not wait for a disk that hangs: another thread reads the file.
class PeersWatch : public QObject
{
    Q_OBJECT

public:
    /// Reads the list, on the other thread; must own all that it uses.
    using Read = std::function<Result<keys::UsablePeers, InputError>()>;
    using Apply = std::function<void(std::vector<channel::Peer>)>;
    /// Measures how long the file has stayed the same. Called on the other thread.
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// A look that takes longer is reported by refused().
    static constexpr std::chrono::seconds kSlow{5};

    /// Reads the list once, as it may have changed since the program read it.
    PeersWatch(const std::string &file, Apply apply, QObject *parent = nullptr);
    PeersWatch(const std::string &file, Read read, Apply apply, Clock clock = &std::chrono::steady_clock::now,
               QObject *parent = nullptr);
    ~PeersWatch() override;

    /// Looks whether the file has changed. Call after a change that need not wait for the system's notification.
    void look();

Q_SIGNALS:
    /// Another list was applied.
    void reloaded(const skyseal::keys::PeersInForce &peers);
    /// Reading is tried again each second; another change or problem is reported again.
    void refused(const skyseal::Reason &problem);
    /// The system does not notify of changes: they take effect up to a second later. `false`: it does again.
    void notificationFailed(bool failed);

private:
    class Reader;
    struct Found;

    void take(Found found);
    void keepWatching();
    void checkDisk();

    const QString m_file;
    const Apply m_apply;
    const std::shared_ptr<Reader> m_reader; ///< used on the other thread
    QFileSystemWatcher m_watcher;
    QTimer m_everySecond, m_settle;
    QElapsedTimer m_lookBegan;
    bool m_looking = false;   ///< the other thread looks at the file
    bool m_lookAgain = false; ///< it was asked for meanwhile
    bool m_slow = false;      ///< kSlow was reported
    bool m_first = true;      ///< no look has ended
    bool m_unwatched = false; ///< the system does not notify
    unsigned m_looks = 0;     ///< while it does not
    engine::FileThread m_files;
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
void reportPeers(const PeersWatch &watch, bool json);

} // namespace skyseal::app
