#include "core/experiment/lab.h"

#include "core/base/research.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/engine/common/mavsec_settings.h"
#include "core/keys/file_io.h"
#include "core/keys/paired_ends.h"
#include "core/link/address_text.h"
#include "core/link/free_port.h"
#include "core/link/steady_now.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "core/metrics/process_usage.h"

#include <QtCore/QFileInfo>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtNetwork/QNetworkInterface>

#include <array>
#include <vector>
#ifdef Q_OS_LINUX
#include <csignal>
#include <sys/prctl.h>
#include <unistd.h>
#endif

namespace skyseal::experiment {

namespace {

constexpr int kStopMs = 3000;
constexpr int kSearchMs = 1000, kMostSearches = 20; ///< for the autopilot's process
constexpr int kFlightRate =
    20; ///< speeds up the flight, so that the vehicle has a position within seconds; telemetry keeps its rates

QString loopback(const char *scheme, quint16 port)
{
    return QStringLiteral("%1:127.0.0.1:%2").arg(QLatin1String(scheme)).arg(port);
}

QStringList relayArguments(const impair::ImpairmentSettings &settings)
{
    const auto number = [](double value) { return QString::number(value, 'g', 17); };
    const auto milliseconds = [&](Duration value) { return number(seconds(value) * 1000); };
    return {QStringLiteral("--loss"),     number(settings.loss),         QStringLiteral("--duplicate"),
            number(settings.duplicate),   QStringLiteral("--reorder"),   number(settings.reorder),
            QStringLiteral("--corrupt"),  number(settings.corrupt),      QStringLiteral("--delay"),
            milliseconds(settings.delay), QStringLiteral("--jitter"),    milliseconds(settings.jitter),
            QStringLiteral("--rate"),     QString::number(settings.baud)};
}

bool isHere(const std::string &host)
{
    const QHostAddress address(QString::fromStdString(host));
    return host == "localhost" || address.isLoopback() || QNetworkInterface::allAddresses().contains(address);
}

/// The program at the other end of the link, which listens there or calls us; `caller`: the address from which it sends
/// datagrams. nullopt for one that is behind a serial line or runs elsewhere.
std::optional<link::PortOwner> programBehind(const link::LinkUrl &vehicle, const std::optional<Address> &caller)
{
    const link::PortKind kind = vehicle.traits().isStream ? link::PortKind::Tcp : link::PortKind::Udp;
    if (vehicle.isListening() && caller)
        return link::datagramSender(*caller);
    if (vehicle.isListening())
        return link::portCaller(kind, vehicle.port());
    return isHere(vehicle.host()) ? link::portOwner(kind, vehicle.port()) : std::nullopt;
}

/// Such an autopilot is known by the address that the agent learns from its datagrams.
bool callsByDatagrams(const std::optional<link::LinkUrl> &vehicle)
{
    return vehicle && vehicle->isListening() && !vehicle->traits().isStream;
}

/// True if the encrypted heartbeat of an autopilot is still one: the agent reads heartbeats, and no key is known to it.
bool keepsHeartbeats(crypto::MavsecKind kind, const Key32 &key)
{
    engine::MavsecSettings settings;
    settings.kind = kind;
    auto cipher = engine::makeMavsecCipher(settings, key);
    if (!cipher)
        return false;
    mavlink::Heartbeat heartbeat;
    heartbeat.autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
    std::array<std::uint8_t, mavlink::Heartbeat::kMaxLength> payload{};
    heartbeat.encode(payload);
    cipher->apply(payload);
    return mavlink::Heartbeat::decode(payload).autopilot != mavlink::MAV_AUTOPILOT_INVALID;
}

Result<void, InputError> writeBareKey(const std::string &path, RandomSource &random)
{
    Key32 key;
    do
        random.fill(key.mutableView());
    while (!keepsHeartbeats(crypto::MavsecKind::ChaCha20, key) || !keepsHeartbeats(crypto::MavsecKind::Aes256Ctr, key));
    return keys::createFile(path, key.view());
}

} // namespace

Lab::Lab(LabPrograms programs, std::optional<link::LinkUrl> vehicle, const Placement &placement)
    : m_programs(std::move(programs)), m_vehicle(std::move(vehicle)), m_placement(placement)
{
    if (m_vehicle)
        m_placement.simulator.reset(); // the autopilot is not ours to place
    const std::vector<std::uint16_t> ports = link::freeUdpPorts(3);
    m_vehiclePort = ports[0];
    m_relayPort = ports[1];
    m_groundPort = ports[2];
    for (QProcess *process : {&m_simulator, &m_agent, &m_relay}) {
        process->setStandardOutputFile(QProcess::nullDevice());
        connect(process, &QProcess::finished, this, [this, process] { reportEnd(*process); });
        connect(process, &QProcess::errorOccurred, this, [this, process](QProcess::ProcessError error) {
            if (error == QProcess::FailedToStart)
                reportEnd(*process);
        });
#ifdef Q_OS_LINUX
        const std::optional<int> core = process == &m_simulator ? m_placement.simulator
            : process == &m_agent                               ? m_placement.agent
                                                                : m_placement.relay;
        process->setChildProcessModifier([core, parent = ::getpid()] {
            ::prctl(PR_SET_PDEATHSIG, SIGTERM);
            if (::getppid() != parent)
                ::_exit(1);  // it was killed before the line above
            ::setpgid(0, 0); // Ctrl+C is for this process, which needs its agent to end in good order
            if (core)
                runOnCore(*core);
        });
#endif
    }
    connect(&m_simulator, &QProcess::readyReadStandardOutput, this, &Lab::readPace);
    connect(&m_agent, &QProcess::readyReadStandardOutput, this, &Lab::readAgent);
    m_relay.setStandardOutputFile(file("relay.log"), QIODevice::Append);
    m_search.setSingleShot(true);
    m_search.setInterval(kSearchMs);
    connect(&m_search, &QTimer::timeout, this, &Lab::findAutopilot);
}

Result<std::unique_ptr<Lab>, InputError> Lab::create(LabPrograms programs, RandomSource &random,
                                                     std::optional<link::LinkUrl> vehicle, const Placement &placement)
{
    for (const auto &[path, name] : {std::pair(programs.simulator, "skyseal-sim"), std::pair(programs.agent, "skyseal-air"),
                                     std::pair(programs.relay, "skyseal-cli")}) {
        const bool isNeeded = !vehicle || path != programs.simulator;
        if (isNeeded && !QFileInfo(path).isExecutable())
            return tl::unexpected(InputError{sentence("Reason", "was not found beside this program or in PATH"), name});
    }
    std::unique_ptr<Lab> lab(new Lab(std::move(programs), std::move(vehicle), placement));
    if (!lab->m_folder.isValid())
        return tl::unexpected(InputError{sentence("Reason", "cannot be created: %1")(lab->m_folder.errorString().toStdString()),
                                         lab->m_folder.path().toStdString()});
    if (auto written = keys::writePairedEnds(lab->m_folder.path().toStdString(), "air", random); !written)
        return tl::unexpected(written.error());
    if (auto written = writeBareKey(lab->bareKey(), random); !written)
        return tl::unexpected(written.error());
    return lab;
}

Lab::~Lab()
{
    stop();
}

engine::KeyPaths Lab::stationKeys() const
{
    return {file("station.key").toStdString(), file("station.peers").toStdString()};
}

void Lab::start(Load load, const Condition &condition, std::uint64_t seed)
{
    stop();
    if (!condition.clean()) {
        m_relayLog.begin();
        launch(m_relay, m_programs.relay,
               QStringList{QStringLiteral("impair"), QStringLiteral("--listen"), loopback("udpin", m_relayPort),
                           QStringLiteral("--to"), loopback("udpout", m_groundPort), QStringLiteral("--json"),
                           QStringLiteral("--drops"), QStringLiteral("--seed"), QString::number(seed)}
                   + relayArguments(condition.settings));
    }
    const QString vehicle = m_vehicle ? QString::fromStdString(m_vehicle->toText()) : loopback("udpin", m_vehiclePort);
    QStringList agent{QStringLiteral("--vehicle"),  vehicle,
                      QStringLiteral("--ground"),   loopback("udpout", condition.clean() ? m_groundPort : m_relayPort),
                      QStringLiteral("--identity"), file("air.key"),
                      QStringLiteral("--peers"),    file("air.peers")}; // no --json: a report each second costs CPU time
    if (kResearch)
        agent << QStringLiteral("--allow-research") << QStringLiteral("--allow-plain") << QStringLiteral("--allow-inline");
    m_caller.reset();
    if (callsByDatagrams(m_vehicle))
        agent << QStringLiteral("--json"); // for the address of the autopilot, in all arms alike
    m_agent.setStandardOutputFile(callsByDatagrams(m_vehicle) ? QString() : QProcess::nullDevice());
    launch(m_agent, m_programs.agent, agent);
    if (m_vehicle) {
        m_searches = kMostSearches;
        return findAutopilot();
    }
    QStringList simulator{QStringLiteral("--link"),    loopback("udpout", m_vehiclePort), QStringLiteral("--seed"),
                          QString::number(seed),       QStringLiteral("--json"),          QStringLiteral("--rate"),
                          QString::number(kFlightRate)};
    if (load == Load::Saturated)
        simulator << QStringLiteral("--saturate");
    if (load.isPaced())
        simulator << QStringLiteral("--pps") << QString::number(load.perSecond);
    if (kResearch)
        simulator << QStringLiteral("--framing") << QStringLiteral("mavsec2019") << QStringLiteral("--stdin")
                  << QStringLiteral("--key-file") << file("bare.key");
    m_missedSends.reset();
    m_simulator.setStandardOutputFile(load.isPaced() ? QString() : QProcess::nullDevice());
    launch(m_simulator, m_programs.simulator, simulator);
}

/// One that calls us does so some time after the agent has started.
void Lab::findAutopilot()
{
    m_autopilot = programBehind(*m_vehicle, m_caller);
    if (!m_autopilot && --m_searches > 0)
        m_search.start();
}

void Lab::setBareCipher(std::optional<crypto::MavsecKind> cipher)
{
    if (m_simulator.state() == QProcess::Running)
        m_simulator.write(QByteArray::fromStdString(std::string(cipher ? crypto::name(*cipher) : "plain")) + '\n');
}

/// Lines that are no counts of the paced load name its link.
void Lab::readPace()
{
    while (m_simulator.canReadLine()) {
        const QJsonObject line = QJsonDocument::fromJson(m_simulator.readLine()).object();
        if (line[QLatin1String("event")] == QLatin1String("pace"))
            m_missedSends = static_cast<std::uint64_t>(line[QLatin1String("missed")].toInteger());
    }
}

/// The address of the autopilot, while its process is not known.
void Lab::readAgent()
{
    while (m_agent.canReadLine()) {
        const QByteArray text = m_agent.readLine();
        if (m_autopilot)
            continue;
        const QJsonObject line = QJsonDocument::fromJson(text).object();
        const std::string caller = line[QLatin1String("vehicle_address")].toString().toStdString();
        if (const auto address = link::parseAddress(caller); address && address != m_caller) {
            m_caller = address;
            findAutopilot();
        }
    }
}

ProgramUsage Lab::usage()
{
    ProgramUsage out;
    out.at = steadyNow();
    out.agentCpu = metrics::processCpuTime(m_agent.processId());
    out.simulatorCpu = metrics::processCpuTime(m_simulator.processId());
    out.relayCpu = metrics::processCpuTime(m_relay.processId());
    if (m_autopilot)
        out.autopilotCpu = metrics::processCpuTime(m_autopilot->process);
    out.agentMemory = metrics::residentBytes(m_agent.processId());
    out.agentSwitches = metrics::contextSwitches(m_agent.processId());
    out.missedSends = m_missedSends;
    if (m_relay.state() == QProcess::Running)
        out.relay = m_relayLog.read();
    return out;
}

std::string Lab::sourceText() const
{
    if (!m_vehicle)
        return "the sweep's own simulator (skyseal-sim)";
    return "the autopilot on " + m_vehicle->toText()
        + (m_autopilot ? ", " + m_autopilot->name + ", whose CPU load is autopilot_cpu"
                       : ", whose process is not known on this machine: autopilot_cpu is empty");
}

void Lab::launch(QProcess &process, const QString &program, const QStringList &arguments)
{
    process.start(program, arguments);
    process.waitForStarted(kStopMs); // for its process id; a failure is reported by the signal
}

void Lab::stop()
{
    m_stopping = true;
    m_search.stop();
    for (QProcess *process : {&m_simulator, &m_agent, &m_relay}) {
        if (process->state() == QProcess::NotRunning)
            continue;
        process->terminate();
        if (!process->waitForFinished(kStopMs)) {
            process->kill();
            process->waitForFinished(kStopMs);
        }
    }
    m_stopping = false;
}

void Lab::reportEnd(QProcess &process)
{
    if (m_stopping)
        return;
    const std::string name = QFileInfo(process.program()).fileName().toStdString();
    if (process.error() == QProcess::FailedToStart) {
        Q_EMIT ended(sentence("Reason", "%1 could not be started: %2")(name, process.errorString().toStdString()));
        return;
    }
    const Reason how = process.exitStatus() == QProcess::CrashExit ? sentence("Reason", "it was killed or crashed")
                                                                   : sentence("Reason", "exit status %1")(process.exitCode());
    const std::string said = process.readAllStandardError().trimmed().split('\n').last().toStdString();
    Q_EMIT ended(said.empty() ? sentence("Reason", "%1 ended by itself: %2")(name, how)
                              : sentence("Reason", "%1 ended by itself: %2 (%3)")(name, how, said));
}

} // namespace skyseal::experiment

#include "moc_lab.cpp"
