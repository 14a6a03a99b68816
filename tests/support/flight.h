// The set that most integration tests need: fresh keys for a ground station and an agent that know each other, and the
// arguments with which simulator, agent and monitor find one another on free ports of 127.0.0.1.
#pragma once

#include "tests/support/program.h"

#include <QtCore/QTemporaryDir>

namespace skyseal::test {

class Flight
{
public:
    Flight();

    /// False when the keys could not be made; tests check it first.
    bool ready() const { return m_ready; }
    QString path(const QString &name) const { return m_folder.filePath(name); }

    quint16 vehiclePort = freeUdpPort(); ///< the agent's vehicle side
    quint16 groundPort = freeUdpPort();  ///< the station's

    QStringList simArguments(const QStringList &more = {}) const;
    /// `ground` where the agent's records go; 0 = straight to the station.
    QStringList airArguments(quint16 ground = 0, const QStringList &more = {}) const;
    QStringList monitorArguments(const QStringList &more = {}) const;

private:
    QTemporaryDir m_folder;
    bool m_ready = false;
};

/// All six authenticated suites, as --switch-to takes them.
QString allSuites();

} // namespace skyseal::test
