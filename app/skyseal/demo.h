// The demo: a simulated vehicle and its agent as child processes on loopback, with keys created for this run. The children end
// with this object, and with the window even if that crashes.
#pragma once

#include "core/base/result.h"
#include "core/engine/station/station.h"

#include <QtCore/QObject>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>

#include <memory>

namespace skyseal::app {

class Demo : public QObject
{
    Q_OBJECT

public:
    /// Creates keys and known peers for both ends in a temporary folder, which ends with this object.
    static Result<std::unique_ptr<Demo>, InputError> create(RandomSource &random);
    ~Demo() override;

    /// The paths of the programs: in the folder of this one, then on the PATH; empty if missing.
    static QString programPath(const QString &name);
    static bool isAvailable();

    /// The key files of the station in the demo.
    engine::KeyPaths stationKeys() const;
    /// For the recordings of the station in the demo: they end with it.
    QString recordFolder() const { return m_folder.filePath(QStringLiteral("recordings")); }
    /// Starts both programs; the agent looks for the station on this port of loopback. Also restarts it when the port
    /// changed.
    void start(quint16 groundPort);
    /// Restarts the programs that ended.
    void restart();

Q_SIGNALS:
    /// A program ended unexpectedly or could not be started; with a sentence for the operator.
    void ended(const QString &problem);

private:
    Demo() = default;

    void launch(QProcess &process, const QString &name, const QStringList &arguments);
    void stop(QProcess &process);
    void reportEnd(const QString &name, QProcess &process);

    QTemporaryDir m_folder;
    QProcess m_simulator, m_agent;
    quint16 m_vehiclePort = 0, m_groundPort = 0;
    bool m_stopping = false;
};

} // namespace skyseal::app
