#include "core/engine/station/station.h"

#include "core/base/research.h"

#include "core/crypto/thread_end.h"
#include "core/engine/common/mailbox.h"
#include "core/engine/station/output_queue.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/engine/station/station_core.h"
#include "core/link/event_loop.h"

#include <QtCore/QThread>
#include <QtCore/QTimer>

#include <functional>
#include <utility>
#include <variant>

namespace skyseal::engine {

namespace {

/// A reader that does not answer for this long counts as hung: heartbeats stop.
constexpr auto kReaderPatience = std::chrono::seconds(3);
constexpr auto kAskReaderEvery = std::chrono::milliseconds(500);

} // namespace

/// Lives on the I/O thread and owns the core there.
class StationWorker : public QObject
{
    Q_OBJECT

public:
    using Task = std::function<void(StationWorker &)>;

    StationWorker(StationConfig config, std::unique_ptr<SecretFiles> secrets)
        : m_config(std::move(config)), m_secrets(std::move(secrets))
    {}

    void begin()
    {
        StationSinks sinks{
            [this](SnapshotPtr snapshot) { publish(std::move(snapshot)); }, [this](Event event) { publish(std::move(event)); },
            [this](channel::PairingEvent event) { publish(std::move(event)); },
            [this](SnapshotPtr snapshot) { publish(Probed{std::move(snapshot)}); }, [this] { return output.eventsDropped(); }};
        m_core = std::make_unique<StationCore>(m_config, std::move(m_secrets), std::move(sinks));
        m_answered = steadyNow();
        m_ask = std::make_unique<QTimer>();
        connect(m_ask.get(), &QTimer::timeout, this, [this] {
            m_core->setReaderAlive(steadyNow() - m_answered < kReaderPatience);
            if (!std::exchange(m_isAsking, true)) // so that a reader that hangs collects no questions
                Q_EMIT readerAsked();
        });
        m_ask->start(kAskReaderEvery);
        runTasks();
    }

    void readerAnswered()
    {
        m_answered = steadyNow();
        m_isAsking = false;
    }

    void runTasks()
    {
        if (!m_core)
            return; // kept until begin()
        for (const Task &task : tasks.takeAll())
            task(*this);
    }

    void stop()
    {
        m_ask.reset();
        publish(Stopped{m_core->stop()});
    }

    void end()
    {
        if (m_ask) // not stopped yet: the peers must not have to wait for a timeout
            m_core->stop();
        m_ask.reset();
        m_core.reset();
        crypto::endThread();
        // Synchronises with the destructor of Station in a way that ThreadSanitizer sees, unlike QThread::wait().
        output.put(Stopped{});
        QThread::currentThread()->quit();
    }

    StationCore &core() { return *m_core; }

    Mailbox<Task> tasks;
    OutputQueue output;

Q_SIGNALS:
    void outputReady();
    void readerAsked();

private:
    void publish(OutputQueue::Item item)
    {
        if (output.put(std::move(item)))
            Q_EMIT outputReady();
    }

    StationConfig m_config;
    std::unique_ptr<SecretFiles> m_secrets;
    std::unique_ptr<StationCore> m_core;
    std::unique_ptr<QTimer> m_ask;
    TimePoint m_answered{};
    bool m_isAsking = false; ///< the reader has not answered yet
};

/// Carries the signals of the reader's thread to the worker's.
class ReaderSignals : public QObject
{
    Q_OBJECT

Q_SIGNALS:
    void tasksPosted();
    void readerAnswered();
};

struct Station::Private
{
    QThread thread;
    std::unique_ptr<StationWorker> worker; ///< used on its own thread until that has ended
    ReaderSignals readerSignals;
    std::optional<channel::PublicKey> publicKey;
    std::uint32_t nextLink = 1;
    std::uint32_t nextRequest = 1;

    /// Runs on the I/O thread, in the order of the calls.
    void postToWorker(StationWorker::Task task)
    {
        if (worker->tasks.put(std::move(task)))
            Q_EMIT readerSignals.tasksPosted();
    }
    template<typename F> void post(F act)
    {
        postToWorker([act = std::move(act)](StationWorker &target) mutable { act(target.core()); });
    }
};

Result<std::unique_ptr<Station>, InputError> Station::create(StationConfig config)
{
    if (!kResearch)
        config.secure = SecureMode::Required;
    std::unique_ptr<SecretFiles> secrets;
    if (config.secure != SecureMode::Off && !config.keys.identity.empty()) {
        auto read = readSecretFiles(config.keys);
        if (!read)
            return tl::unexpected(read.error());
        secrets = std::move(*read);
    }
    auto parts = std::make_unique<Private>();
    if (secrets)
        parts->publicKey = secrets->publicKey();
    parts->worker = std::make_unique<StationWorker>(std::move(config), std::move(secrets));
    return std::unique_ptr<Station>(new Station(std::move(parts)));
}

Station::Station(std::unique_ptr<Private> parts) : d(std::move(parts))
{
    qRegisterMetaType<std::shared_ptr<const Snapshot>>();
    qRegisterMetaType<Event>();
    StationWorker *worker = d->worker.get();
    worker->moveToThread(&d->thread);
    connect(worker, &StationWorker::outputReady, this, [this, worker] {
        for (const OutputQueue::Item &item : worker->output.takeAll()) {
            if (const auto *snapshot = std::get_if<SnapshotPtr>(&item))
                Q_EMIT snapshotReady(*snapshot);
            else if (const auto *event = std::get_if<Event>(&item))
                Q_EMIT eventOccurred(*event);
            else if (const auto *pairingEvent = std::get_if<channel::PairingEvent>(&item))
                Q_EMIT pairing(*pairingEvent);
            else if (const auto *probed = std::get_if<Probed>(&item))
                Q_EMIT probeTaken(probed->snapshot);
            else
                Q_EMIT stopped(std::get<Stopped>(item).last);
        }
    });
    connect(&d->readerSignals, &ReaderSignals::tasksPosted, worker, &StationWorker::runTasks);
    // The question passes through this thread's event loop, so that there is no answer while this thread hangs.
    connect(worker, &StationWorker::readerAsked, &d->readerSignals, &ReaderSignals::readerAnswered);
    connect(&d->readerSignals, &ReaderSignals::readerAnswered, worker, &StationWorker::readerAnswered);
    connect(&d->thread, &QThread::started, worker, &StationWorker::begin);
    link::installEventLoop(d->thread);
    d->thread.setObjectName(QStringLiteral("skyseal-io"));
    d->thread.start();
}

Station::~Station()
{
    d->postToWorker([](StationWorker &worker) { worker.end(); });
    d->thread.wait();
    d->worker->output.takeAll();
}

LinkId Station::addLink(const link::LinkUrl &url)
{
    const LinkId id{d->nextLink++};
    d->post([id, url](StationCore &core) { core.addLink(id, url); });
    return id;
}

LinkId Station::addMavsecLink(const link::LinkUrl &url, crypto::MavsecCipher cipher)
{
    const LinkId id{d->nextLink++};
    // Tasks are copied; the cipher contains key material, which must not be copied.
    const auto held = std::make_shared<crypto::MavsecCipher>(std::move(cipher));
    d->post([id, url, held](StationCore &core) { core.addMavsecLink(id, url, std::move(*held)); });
    return id;
}

void Station::removeLink(LinkId id)
{
    d->post([id](StationCore &core) { core.removeLink(id); });
}

void Station::serve(std::vector<ServeConfig> served)
{
    d->post([served = std::move(served)](StationCore &core) mutable { core.serve(std::move(served)); });
}

void Station::setFeed(std::shared_ptr<Feed> feed)
{
    d->post([feed = std::move(feed)](StationCore &core) { core.setFeed(feed); });
}

void Station::switchSuite(channel::SessionId session, crypto::SuiteId suite)
{
    d->post([=](StationCore &core) { core.switchSuite(session, suite); });
}

void Station::holdSuite(std::optional<crypto::SuiteId> suite)
{
    d->post([suite](StationCore &core) { core.holdSuite(suite); });
}

void Station::resumeSuite(crypto::SuiteId suite)
{
    d->post([suite](StationCore &core) { core.resumeSuite(suite); });
}

void Station::setWeakestSuite(crypto::SuiteId weakest)
{
    d->post([weakest](StationCore &core) { core.setWeakestSuite(weakest); });
}

void Station::setAllowResearch(bool allow)
{
    d->post([allow](StationCore &core) { core.setAllowResearch(allow); });
}

void Station::setPeers(std::vector<channel::Peer> peers)
{
    d->post([peers = std::move(peers)](StationCore &core) mutable { core.setPeers(std::move(peers)); });
}

void Station::allowPlaintext(std::uint8_t systemId)
{
    d->post([systemId](StationCore &core) { core.allowPlaintext(systemId); });
}

void Station::forgetVehicle(std::uint8_t systemId)
{
    d->post([systemId](StationCore &core) { core.forgetVehicle(systemId); });
}

void Station::openPairing(std::string name, std::shared_ptr<const crypto::Passphrase> passphrase)
{
    d->post([name = std::move(name), passphrase = std::move(passphrase)](StationCore &core) mutable {
        core.openPairing(std::move(name), std::move(passphrase));
    });
}

void Station::confirmPairing(const channel::PublicKey &key)
{
    d->post([key](StationCore &core) { core.confirmPairing(key); });
}

void Station::refusePairing()
{
    d->post([](StationCore &core) { core.refusePairing(); });
}

void Station::cancelPairing()
{
    d->post([](StationCore &core) { core.cancelPairing(); });
}

vehicle::RequestId Station::perform(std::uint8_t systemId, vehicle::Request request)
{
    const vehicle::RequestId id{d->nextRequest++};
    d->post([=, request = std::move(request)](StationCore &core) { core.perform(id, systemId, request); });
    return id;
}

void Station::setInspecting(bool inspecting)
{
    d->post([inspecting](StationCore &core) { core.setInspecting(inspecting); });
}

void Station::chooseFields(std::vector<FieldChoice> choices)
{
    d->post([choices = std::move(choices)](StationCore &core) { core.chooseFields(choices); });
}

void Station::setRecording(bool recording)
{
    d->post([recording](StationCore &core) { core.setRecording(recording); });
}

void Station::setMeasuring(bool measuring)
{
    d->post([measuring](StationCore &core) { core.setMeasuring(measuring); });
}

void Station::requestCosts(bool request)
{
    d->post([request](StationCore &core) { core.requestCosts(request); });
}

void Station::requestProbe()
{
    d->post([](StationCore &core) { core.requestProbe(); });
}

void Station::setSnapshotsPerSecond(int perSecond)
{
    d->post([perSecond](StationCore &core) { core.setSnapshotsPerSecond(perSecond); });
}

void Station::setProtection(std::optional<Protection> protection)
{
    d->post([protection](StationCore &core) { core.setProtection(protection); });
}

void Station::setBareCipher(std::optional<crypto::MavsecCipher> cipher)
{
    const auto held = std::make_shared<std::optional<crypto::MavsecCipher>>(std::move(cipher)); // see addMavsecLink()
    d->post([held](StationCore &core) { core.setBareCipher(std::move(*held)); });
}

void Station::stop()
{
    d->postToWorker([](StationWorker &worker) { worker.stop(); });
}

std::optional<channel::PublicKey> Station::publicKey() const
{
    return d->publicKey;
}

} // namespace skyseal::engine

#include "moc_station.cpp"
#include "station.moc"
