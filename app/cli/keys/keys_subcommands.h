// The subcommands of skyseal-cli keys. Each takes its arguments and returns the exit status.
#pragma once

#include <QtCore/QStringList>

namespace skyseal::app {

// A device's own key: own_key_commands.cpp
int newKey(const QStringList &arguments);
int showKey(const QStringList &arguments);
int exportKey(const QStringList &arguments);
int importKey(const QStringList &arguments);
int changePassphrase(const QStringList &arguments);
int newPresharedKey(const QStringList &arguments);

// With an agent: pair_command.cpp
int pairWithAgent(const QStringList &arguments);

// Known peers: peers_commands.cpp
int addPeer(const QStringList &arguments);
int listPeers(const QStringList &arguments);
int removePeer(const QStringList &arguments);
int renamePeer(const QStringList &arguments);
int setPeerRole(const QStringList &arguments);
int setPeerSystems(const QStringList &arguments);

} // namespace skyseal::app
