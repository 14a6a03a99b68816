#include "core/engine/station.h"

#include "core/engine/station_core.h"

#include <QtCore/QThread>
#include <QtCore/QTimer>

#include <atomic>

namespace skyseal::engine {

namespace {

/// How long the reader may stand still before nobody pretends any more that an operator is there.
constexpr auto kReaderPatience = std::chrono::seconds(3);
constexpr auto kAskReaderEvery = std::chrono::milliseconds(500);

} // namespace

/// Lives on the I/O thread; owns the core there.
class StationWorker : public QObject
{
    Q_OBJECT

public:
    StationWorker(StationConfig config, std::unique_ptr<SecretFiles> secrets)
        : m_config(std::move(config)), m_secrets(std::move(secrets))
    {
    }

    void begin()
    {
        m_core = std::make_unique<StationCore>(
            m_config, std::move(m_secrets),
            StationSinks{[this](std::shared_ptr<const Snapshot> snapshot) { Q_EMIT snapshotTaken(snapshot); },
                         [this](Happening happening) { Q_EMIT happened(happening); }});
        m_answered = steadyNow();
        m_ask = std::make_unique<QTimer>();
        connect(m_ask.get(), &QTimer::timeout, this, [this] {
            m_core->setReaderAlive(steadyNow() - m_answered < kReaderPatience);
            Q_EMIT readerAsked();
        });
        m_ask->start(kAskReaderEvery);
    }

    void readerAnswered() { m_answered = steadyNow(); }
    StationCore &core() { return *m_core; }

    void stop()
    {
        m_ask.reset();
        Q_EMIT stopped(m_core->stop());
    }

    void end()
    {
        m_ask.reset();
        m_core.reset();
    }

Q_SIGNALS:
    void snapshotTaken(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void happened(skyseal::engine::Happening happening);
    void readerAsked();
    void stopped(std::shared_ptr<const skyseal::engine::Snapshot> last);

private:
    StationConfig m_config;
    std::unique_ptr<SecretFiles> m_secrets;
    std::unique_ptr<StationCore> m_core;
    std::unique_ptr<QTimer> m_ask;
    TimePoint m_answered{};
};

struct Station::Private
{
    QThread thread;
    StationWorker *worker = nullptr; ///< deleted on its own thread when that ends
    KeyPaths paths;
    std::optional<channel::PublicKey> publicKey;
    std::uint32_t nextLink = 1;
    std::uint32_t nextCommand = 1;

    /// Runs on the I/O thread, in the order of the calls.
    template<typename F> void post(F &&act)
    {
        QMetaObject::invokeMethod(
            worker, [target = worker, act = std::forward<F>(act)]() mutable { act(target->core()); }, Qt::QueuedConnection);
    }
};

Result<std::unique_ptr<Station>, InputError> Station::create(StationConfig config)
{
    std::unique_ptr<SecretFiles> secrets;
    if (config.secure != SecureMode::Off && !config.keys.identity.empty()) {
        auto read = readSecretFiles(config.keys);
        if (!read)
            return tl::unexpected(read.error());
        secrets = std::move(*read);
    }
    auto parts = std::make_unique<Private>();
    parts->paths = config.keys;
    if (secrets)
        parts->publicKey = secrets->identity->publicKey;
    parts->worker = new StationWorker(std::move(config), std::move(secrets));
    return std::unique_ptr<Station>(new Station(std::move(parts)));
}

Station::Station(std::unique_ptr<Private> parts) : d(std::move(parts))
{
    qRegisterMetaType<std::shared_ptr<const Snapshot>>();
    qRegisterMetaType<Happening>();
    StationWorker *worker = d->worker;
    worker->moveToThread(&d->thread);
    connect(worker, &StationWorker::snapshotTaken, this, &Station::snapshotReady);
    connect(worker, &StationWorker::happened, this, &Station::happened);
    connect(worker, &StationWorker::stopped, this, &Station::stopped);
    // Goes through this thread's event loop and back: no answer comes while it hangs.
    connect(worker, &StationWorker::readerAsked, this, [this, worker] {
        QMetaObject::invokeMethod(worker, [worker] { worker->readerAnswered(); }, Qt::QueuedConnection);
    });
    connect(&d->thread, &QThread::started, worker, &StationWorker::begin);
    connect(&d->thread, &QThread::finished, worker, &QObject::deleteLater);
    d->thread.setObjectName(QStringLiteral("skyseal-io"));
    d->thread.start();
}

Station::~Station()
{
    StationWorker *worker = d->worker;
    QMetaObject::invokeMethod(
        worker,
        [worker] {
            worker->end();
            QThread::currentThread()->quit();
        },
        Qt::QueuedConnection);
    d->thread.wait();
}

LinkId Station::addLink(const link::LinkUrl &url)
{
    const LinkId id{d->nextLink++};
    d->post([id, url](StationCore &core) { core.addLink(id, url); });
    return id;
}

void Station::removeLink(LinkId id)
{
    d->post([id](StationCore &core) { core.removeLink(id); });
}

void Station::switchSuite(channel::SessionId session, crypto::SuiteId suite)
{
    d->post([=](StationCore &core) { core.switchSuite(session, suite); });
}

void Station::setPreferredSuite(crypto::SuiteId suite)
{
    d->post([suite](StationCore &core) { core.setPreferredSuite(suite); });
}

void Station::setAllowResearch(bool allow)
{
    d->post([allow](StationCore &core) { core.setAllowResearch(allow); });
}

Result<void, InputError> Station::reloadPeers()
{
    auto peers = readPeers(d->paths);
    if (!peers)
        return tl::unexpected(peers.error());
    d->post([list = std::move(*peers)](StationCore &core) mutable { core.setPeers(std::move(list)); });
    return {};
}

vehicle::CommandId Station::command(std::uint8_t systemId, vehicle::VehicleCommand command)
{
    const vehicle::CommandId id{d->nextCommand++};
    d->post([=, command = std::move(command)](StationCore &core) { core.command(id, systemId, command); });
    return id;
}

void Station::requestParameters(std::uint8_t systemId)
{
    d->post([=](StationCore &core) {
        core.withVehicle(systemId, [](vehicle::Vehicle &vehicle, TimePoint now) { vehicle.requestParameters(now); });
    });
}

void Station::writeParameter(std::uint8_t systemId, std::string name, double value)
{
    d->post([=, name = std::move(name)](StationCore &core) {
        core.withVehicle(systemId,
                         [&](vehicle::Vehicle &vehicle, TimePoint now) { vehicle.writeParameter(now, name, value); });
    });
}

void Station::readMission(std::uint8_t systemId)
{
    d->post([=](StationCore &core) {
        core.withVehicle(systemId, [](vehicle::Vehicle &vehicle, TimePoint now) { vehicle.readMission(now); });
    });
}

void Station::writeMission(std::uint8_t systemId, std::vector<vehicle::MissionItem> items)
{
    d->post([=, items = std::move(items)](StationCore &core) {
        core.withVehicle(systemId, [&](vehicle::Vehicle &vehicle, TimePoint now) { vehicle.writeMission(now, items); });
    });
}

void Station::setInspecting(bool inspecting)
{
    d->post([inspecting](StationCore &core) { core.setInspecting(inspecting); });
}

void Station::setRecording(bool recording)
{
    d->post([recording](StationCore &core) { core.setRecording(recording); });
}

void Station::stop()
{
    QMetaObject::invokeMethod(d->worker, [worker = d->worker] { worker->stop(); }, Qt::QueuedConnection);
}

std::optional<channel::PublicKey> Station::publicKey() const
{
    return d->publicKey;
}

} // namespace skyseal::engine

#include "station.moc"
