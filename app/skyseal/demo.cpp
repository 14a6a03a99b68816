#include "app/skyseal/demo.h"

#include "core/base/research.h"
#include "core/keys/paired_ends.h"
#include "core/link/free_port.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>

#ifdef Q_OS_LINUX
#include <csignal>
#include <sys/prctl.h>
#endif

namespace skyseal::app {

namespace {

const QString kSimulator = QStringLiteral("skyseal-sim");
const QString kAgent = QStringLiteral("skyseal-air");
constexpr int kStopMs = 2000;

} // namespace

QString Demo::programPath(const QString &name)
{
    const QFileInfo beside(QCoreApplication::applicationDirPath() + QLatin1Char('/') + name);
    return beside.isExecutable() ? beside.absoluteFilePath() : QStandardPaths::findExecutable(name);
}

bool Demo::isAvailable()
{
    return !programPath(kSimulator).isEmpty() && !programPath(kAgent).isEmpty();
}

Result<std::unique_ptr<Demo>, InputError> Demo::create(RandomSource &random)
{
    std::unique_ptr<Demo> demo(new Demo);
    if (!demo->m_folder.isValid())
        return tl::unexpected(
            InputError{sentence("Reason", "cannot be created: %1")(demo->m_folder.errorString().toStdString()),
                       demo->m_folder.path().toStdString()});
    if (auto written = keys::writePairedEnds(demo->m_folder.path().toStdString(), "air-demo", random); !written)
        return tl::unexpected(written.error());
    return demo;
}

Demo::~Demo()
{
    m_stopping = true;
    stop(m_agent);
    stop(m_simulator);
}

engine::KeyPaths Demo::stationKeys() const
{
    return {m_folder.filePath(QStringLiteral("station.key")).toStdString(),
            m_folder.filePath(QStringLiteral("station.peers")).toStdString()};
}

void Demo::start(quint16 groundPort)
{
    if (m_vehiclePort == 0) {
        m_vehiclePort = link::freeUdpPorts(1).front();
        for (QProcess *process : {&m_simulator, &m_agent}) {
            const QString name = process == &m_simulator ? kSimulator : kAgent;
            process->setStandardOutputFile(QProcess::nullDevice());
            connect(process, &QProcess::finished, this, [this, name, process] { reportEnd(name, *process); });
            connect(process, &QProcess::errorOccurred, this, [this, name, process](QProcess::ProcessError error) {
                if (error == QProcess::FailedToStart)
                    reportEnd(name, *process);
            });
        }
    }
    if (m_groundPort != 0 && m_groundPort != groundPort) {
        m_stopping = true;
        stop(m_agent);
        m_stopping = false;
    }
    m_groundPort = groundPort;
    restart();
}

void Demo::restart()
{
    const QString vehicle = QStringLiteral("127.0.0.1:%1").arg(m_vehiclePort);
    if (m_agent.state() == QProcess::NotRunning) {
        QStringList agent{QStringLiteral("--vehicle"),  QStringLiteral("udpin:") + vehicle,
                          QStringLiteral("--ground"),   QStringLiteral("udpout:127.0.0.1:%1").arg(m_groundPort),
                          QStringLiteral("--identity"), m_folder.filePath(QStringLiteral("air.key")),
                          QStringLiteral("--peers"),    m_folder.filePath(QStringLiteral("air.peers"))};
        if (kResearch)
            agent << QStringLiteral("--allow-research") << QStringLiteral("--allow-inline");
        launch(m_agent, kAgent, agent);
    }
    if (m_simulator.state() == QProcess::NotRunning)
        launch(m_simulator, kSimulator, {QStringLiteral("--link"), QStringLiteral("udpout:") + vehicle});
}

void Demo::launch(QProcess &process, const QString &name, const QStringList &arguments)
{
    const QString program = programPath(name);
    if (program.isEmpty()) {
        Q_EMIT ended(tr("The demo needs %1, which was not found beside this program or in PATH.").arg(name));
        return;
    }
#ifdef Q_OS_LINUX
    process.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGTERM); });
#endif
    process.start(program, arguments);
}

void Demo::stop(QProcess &process)
{
    if (process.state() == QProcess::NotRunning)
        return;
    process.terminate();
    if (!process.waitForFinished(kStopMs)) {
        process.kill();
        process.waitForFinished(kStopMs);
    }
}

void Demo::reportEnd(const QString &name, QProcess &process)
{
    if (m_stopping)
        return;
    if (process.error() == QProcess::FailedToStart) {
        Q_EMIT ended(tr("The demo's %1 could not be started: %2").arg(name, process.errorString()));
        return;
    }
    const QStringList lines =
        QString::fromLocal8Bit(process.readAllStandardError()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    const QString how = process.exitStatus() == QProcess::CrashExit ? tr("it was killed or crashed")
        : lines.isEmpty()                                           ? tr("exit status %1").arg(process.exitCode())
                                                                    : lines.last();
    Q_EMIT ended(tr("The demo's %1 exited: %2").arg(name, how));
}

} // namespace skyseal::app

#include "moc_demo.cpp"
