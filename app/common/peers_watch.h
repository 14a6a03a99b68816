// Watches the file of known peers while a program runs, so that whoever is removed from it loses the session at once. A bad
// edit is refused and told, and the list that was read before stays in force.
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
    /// Reads the file and puts it into force; what of it, or why not.
    using Reload = std::function<Result<keys::PeersInForce, InputError>()>;

    PeersWatch(const std::string &file, Reload reload, QObject *parent = nullptr);

Q_SIGNALS:
    void reloaded(const skyseal::keys::PeersInForce &peers);
    /// `problem` is a sentence for people.
    void refused(const QString &problem);

private:
    /// What tells one state of the file from another without reading it.
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

/// {"event":"peers","count":…}, with a "problem" when somebody is left out, and {"event":"peers","problem":…}
std::string peersEvent(const keys::PeersInForce &peers);
std::string peersEvent(const std::string &problem);
/// The same for people.
std::string peersText(const keys::PeersInForce &peers);
std::string peersText(const std::string &problem);

/// Says on stdout (with `json`) or stderr what the watch meets.
void tellPeers(const PeersWatch &watch, bool json);

} // namespace skyseal::app
