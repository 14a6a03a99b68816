// Watches the file of known peers while a program runs, so that the session of a removed peer ends at once. An invalid edit is
// reported, and the previous list stays in force.
#pragma once

#include "core/base/result.h"
#include "core/keys/peers_file.h"

#include <QtCore/QFileSystemWatcher>
#include <QtCore/QObject>
#include <QtCore/QTimer>

#include <cstdint>
#include <functional>
#include <string>

namespace skyseal::app {

/// Lives on the thread of its event loop.
class PeersWatch : public QObject
{
    Q_OBJECT

public:
    /// Callback that reads the file and applies it; returns the result or the reason for refusing it.
    using Reload = std::function<Result<keys::PeersInForce, InputError>()>;

    PeersWatch(const std::string &file, Reload reload, QObject *parent = nullptr);

Q_SIGNALS:
    void reloaded(const skyseal::keys::PeersInForce &peers);
    /// `problem`: a sentence for the user.
    void refused(const QString &problem);

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
    Stamp stamp() const;

    QString m_file;
    Reload m_reload;
    QFileSystemWatcher m_watcher;
    QTimer m_settle;
    Stamp m_seen;
};

/// {"event":"peers","count":…}, with a "problem" if a peer is excluded, and {"event":"peers","problem":…}
std::string peersEvent(const keys::PeersInForce &peers);
std::string peersEvent(const std::string &problem);
/// The same as text.
std::string peersText(const keys::PeersInForce &peers);
std::string peersText(const std::string &problem);

/// Reports the results of the watch on stdout (with `json`) or stderr.
void tellPeers(const PeersWatch &watch, bool json);

} // namespace skyseal::app
