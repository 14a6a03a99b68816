// Common setup of integration tests: fresh keys of a ground station and an agent that list each other as peers, and arguments
// that connect simulator, agent and monitor through free ports of 127.0.0.1.
#pragma once

#include "tests/support/program.h"

#include <QtCore/QTemporaryDir>

namespace skyseal::test {

class Flight
{
public:
    Flight();

    /// Returns false if the keys could not be made. Check it first.
    bool ready() const { return m_ready; }
    QString path(const QString &name) const { return m_folder.filePath(name); }

    quint16 vehiclePort = freeUdpPort(); ///< the agent's vehicle side
    quint16 groundPort = freeUdpPort();  ///< the station's

    QStringList simArguments(const QStringList &more = {}) const;
    /// `ground`: the port to which the agent sends; 0 = the station's.
    QStringList airArguments(quint16 ground = 0, const QStringList &more = {}) const;
    QStringList monitorArguments(const QStringList &more = {}) const;

private:
    QTemporaryDir m_folder;
    bool m_ready = false;
};

/// All suites that seal, as --switch-to takes them. The preferred one, with which a session begins, is the last.
QString allSuites();

} // namespace skyseal::test
