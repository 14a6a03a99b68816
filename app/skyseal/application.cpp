#include "app/skyseal/application.h"

#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "core/crypto/passphrase.h"
#include "core/channel/policy.h"
#include "core/channel/suite_strength.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/text/qt_text.h"
#include "core/keys/secret_file.h"
#include "core/link/free_port.h"
#include "ui/charts/chart_export.h"
#include "ui/replay/rescue_bar.h"
#include "ui/text/command_permits.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>
#include <QtCore/QTimer>
#include <QtGui/QImage>
#include <QtGui/QPixmap>
#include <QtWidgets/QApplication>

namespace skyseal::app {

namespace {

constexpr quint16 kUsualPort = 14550;
constexpr QSize kLeastPicture(1280, 800); // also on the small screen that is none

const QString kName = QStringLiteral("skyseal");

bool isSealed(const std::string &identity)
{
    const auto facts = keys::readIdentityFacts(identity);
    return facts && facts->sealed;
}

/// True if the passphrase of the key has yet to come, from the keyring or the operator.
bool isLocked(const engine::KeyPaths &paths)
{
    return !paths.identity.empty() && !paths.askPassphrase && isSealed(paths.identity);
}

} // namespace

Application::Application(WindowOptions options, RandomSource &random, std::shared_ptr<experiment::HeapFigures> heap,
                         std::unique_ptr<PassphraseMemory> memory)
    : m_options(std::move(options)), m_random(random), m_heap(std::move(heap)),
      m_memory(memory ? std::move(memory) : desktopMemory(m_store))
{}

Application::~Application()
{
    // Delete the window first, since it uses the station.
    m_window.reset();
    m_sweep.reset();
    m_demoFlight.reset();
    m_station.reset();
    m_demo.reset(); // with the folder into which the station recorded
}

engine::StationConfig Application::configOf(const ui::Settings &settings, engine::KeyPaths keys) const
{
    engine::StationConfig config;
    config.systemId = static_cast<std::uint8_t>(settings.systemId);
    config.componentId = static_cast<std::uint8_t>(settings.componentId);
    config.secure = settings.requireSealed ? engine::SecureMode::Required : engine::SecureMode::Preferred;
    config.keys = std::move(keys);
    config.policy.suites = channel::notWeakerThan(settings.weakestSuite, channel::defaultSuites());
    config.policy.allowResearch = settings.allowResearch;
    config.record = settings.record;
    const QString own = settings.recordFolder.isEmpty() ? defaultRecordFolder() : settings.recordFolder;
    config.recordFolder = (m_demo ? m_demo->recordFolder() : own).toStdString();
    return config;
}

engine::KeyPaths Application::chooseKeys()
{
    const keys::AskPassphrase ask = m_options.passphrase.isGiven() ? m_options.passphrase.ask() : keys::AskPassphrase();
    if (!m_options.identityFile.empty())
        return {m_options.identityFile, m_options.peersFile, ask};
    auto own = ownKeys(m_random);
    if (own)
        return {own->identity, own->peers, ask};
    m_keyProblem = engine::reasonText(own.error().reason());
    return {};
}

/// Shows these files in the windows; changes of them apply at once.
void Application::useKeys(const engine::KeyPaths &keys)
{
    m_keys = keys;
    m_keyring.use(keys);
    showKeyState();
    m_pairing.use(*m_station, keys.peers);
    m_peersWatch.reset();
    if (keys.peers.empty())
        return;
    m_peersWatch = std::make_unique<PeersWatch>(
        keys.peers, [this](std::vector<channel::Peer> peers) { m_station->setPeers(std::move(peers)); });
    connect(m_peersWatch.get(), &PeersWatch::reloaded, this, [this](const keys::PeersInForce &peers) {
        m_keyring.touched();
        reportLeftOutPeers(peers);
    });
    connect(m_peersWatch.get(), &PeersWatch::refused, this, [this](const Reason &problem) {
        m_keyring.touched();
        m_window->reportProblem(
            tr("The list of peers cannot be used; the previous list stays in force: %1").arg(engine::reasonText(problem)));
    });
    connect(m_peersWatch.get(), &PeersWatch::notificationFailed, this, [this](bool failed) {
        if (failed)
            m_window->reportProblem(tr("The system does not report changes to the list of peers; it is checked once a second"));
    });
}

void Application::reportLeftOutPeers(const keys::PeersInForce &peers)
{
    if (!peers.leftOut.empty())
        m_window->reportProblem(tr("Ignored entries in the list of peers: %1").arg(engine::reasonText(peers.leftOut)));
}

void Application::showKeyState()
{
    m_keyring.setProblem(m_keyProblem);
    m_window->setKeyState({m_keyProblem, m_question.isOpening()});
}

void Application::reportKeyProblem()
{
    const QString text = tr("No sealed links: %1").arg(m_keyProblem);
    if (isSealed(m_keys.identity))
        m_window->reportProblem(text, tr("Enter the passphrase"), [this] { askForPassphrase(); });
    else
        m_window->reportProblem(text);
}

/// The links wait for a key whose passphrase is remembered, at most as long as it takes to hash it and to unlock the keyring.
/// While the operator is asked, they are open for plain MAVLink.
void Application::openKeyAndLinks(bool locked)
{
    if (locked && m_question.isRemembered(m_keys.identity)) {
        m_question.recall(
            *m_window, m_keys.identity, [this](const PassphraseQuestion::Identity &identity) { useOpenedKeys(identity); },
            [this](const InputError &why) {
                openKeptLinks();
                takeKeyProblem(why);
            },
            [this](bool wrong) {
                openKeptLinks();
                askForPassphrase(wrong ? ui::RefusedPassphrase::Remembered : ui::RefusedPassphrase::None);
            });
        return;
    }
    openKeptLinks();
    if (locked)
        askForPassphrase();
    else if (!m_keyProblem.isEmpty())
        reportKeyProblem();
}

void Application::askForPassphrase(ui::RefusedPassphrase refused)
{
    m_question.ask(
        *m_window, m_keys.identity, [this](const PassphraseQuestion::Identity &identity) { useOpenedKeys(identity); },
        [this](const InputError &why) { takeKeyProblem(why); }, refused);
}

void Application::useOpenedKeys(const PassphraseQuestion::Identity &identity)
{
    m_keyProblem.clear();
    engine::KeyPaths keys = m_keys;
    keys.opened = identity;
    keepLinks();
    exchangeStation(keys);
    useKeys(m_keys);
    openKeptLinks();
    if (!m_keyProblem.isEmpty())
        reportKeyProblem();
}

void Application::takeKeyProblem(const InputError &why)
{
    m_keyProblem = engine::reasonText(why.reason());
    showKeyState();
    reportKeyProblem();
}

/// If the keys cannot be used, the station works without them, for plain links.
void Application::exchangeStation(const engine::KeyPaths &keys)
{
    const auto exchanged = m_station->exchange(configOf(m_window->settings(), keys));
    if (exchanged)
        return;
    m_keyProblem = engine::reasonText(exchanged.error().reason());
    m_station->exchange(configOf(m_window->settings(), {}));
}

bool Application::start()
{
    const ui::Settings settings = ui::loadSettings(m_store);
    engine::KeyPaths keys;
    if (m_options.demo) {
        auto demo = Demo::create(m_random);
        if (!demo) {
            complain(kName, demo.error().text());
            return false;
        }
        m_demo = std::move(*demo);
        keys = m_demo->stationKeys();
    } else {
        keys = chooseKeys();
    }
    // Neither a passphrase that has yet to come nor a damaged key must prevent the window from opening.
    const bool locked = !m_demo && isLocked(keys);
    auto station = engine::Station::create(configOf(settings, locked ? engine::KeyPaths() : keys));
    if (locked) {
        m_keyProblem = engine::reasonText(PassphraseQuestion::notGiven(keys.identity).reason());
    } else if (!station && !m_demo && m_options.identityFile.empty()) {
        m_keyProblem = engine::reasonText(station.error().reason());
        station = engine::Station::create(configOf(settings, {}));
    }
    if (!station) {
        complain(kName, station.error().text());
        return false;
    }
    m_station = std::make_unique<StationAdapter>(std::move(*station));
    makeWindow();
    useKeys(keys);
    m_window->show();
    collectHeapFigures();
    m_keptLinks = linksOfStart();
    if (m_demo) {
        beginDemo();
    } else {
        openKeyAndLinks(locked);
        offerRescue();
    }
    if (!m_options.screenshot.isEmpty()) {
        m_window->resize(m_window->size().expandedTo(kLeastPicture));
        QTimer::singleShot(qRound(m_options.screenshotAfter * 1000), this, &Application::takeScreenshot);
    }
    return true;
}

void Application::makeWindow()
{
    ui::ProgramFacts facts;
    facts.version = QCoreApplication::applicationVersion();
    facts.recordFolder = defaultRecordFolder();
    facts.cacheFolder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/tiles");
    facts.demoAvailable = Demo::isAvailable();
    facts.sessionBytes = [heap = m_heap](crypto::SuiteId suite) { return heap ? heap->session(suite) : std::nullopt; };
    m_window = std::make_unique<ui::MainWindow>(*m_station, m_store, std::move(facts));
    connect(m_station.get(), &StationAdapter::failed, m_window.get(),
            [this](const QString &problem) { m_window->reportProblem(problem); });
    connect(&m_question, &PassphraseQuestion::openingChanged, m_window.get(), [this] { showKeyState(); });
    connect(m_memory.get(), &PassphraseMemory::failed, m_window.get(),
            [this](const QString &problem) { m_window->reportProblem(problem); });
    connect(m_station.get(), &StationAdapter::linkAdded, this, &Application::followLink);
    connect(m_station.get(), &StationAdapter::snapshotReady, this,
            [this](const engine::SnapshotPtr &snapshot) { markRun(*snapshot); });
    m_window->setKeyring(m_keyring, &m_pairing);
    m_sweep = std::make_unique<SweepController>(*m_station, m_heap);
    m_window->setSweep(*m_sweep);
    connect(m_station.get(), &StationAdapter::eventOccurred, &m_keyring, &Keyring::handleEvent);
    connect(&m_keyring, &Keyring::edited, this, [this] {
        if (m_peersWatch)
            m_peersWatch->look();
    });
    connect(m_window.get(), &ui::MainWindow::demoRequested, this, &Application::startDemo);
    connect(m_window.get(), &ui::MainWindow::demoEndRequested, this, &Application::endDemo);
}

/// Those of the command line, or that of the settings.
QStringList Application::linksOfStart() const
{
    QStringList out;
    for (const link::LinkUrl &url : m_options.links)
        out << QString::fromStdString(url.toText());
    if (out.isEmpty())
        out << m_window->settings().defaultLink;
    return out;
}

/// Before another station takes the place of this one, which closes its links: whether the operator or the command line opened
/// them.
void Application::keepLinks()
{
    if (!m_keptLinks.isEmpty())
        return; // they are not open yet
    const auto &snapshot = m_window->view().station();
    if (!snapshot) {
        m_keptLinks = linksOfStart();
        return;
    }
    for (const engine::LinkSnapshot &link : snapshot->links)
        if (!link.listenOnly) // such a link needs its key as well
            m_keptLinks << QString::fromStdString(link.url);
}

void Application::openKeptLinks()
{
    for (const QString &url : std::exchange(m_keptLinks, {}))
        m_window->addLink(url);
}

/// Notes what the next start needs if this run does not end properly. The demo leaves nothing to rescue.
void Application::markRun(const engine::Snapshot &snapshot)
{
    RunRecord record;
    if (!m_demo) {
        if (snapshot.recording.bytes > 0)
            record.recording = QString::fromStdString(snapshot.recording.file);
        for (const engine::LinkSnapshot &link : snapshot.links)
            if (!link.listenOnly) // such a link needs its key as well
                record.links << QString::fromStdString(link.url);
    }
    m_marker.update(record);
}

/// Quietly: a bar with what the last run has left.
void Application::offerRescue()
{
    const auto left = m_marker.takeUnfinished();
    if (!left)
        return;
    ui::UnfinishedRun run{QFileInfo::exists(left->recording) ? left->recording : QString(), {}, left->last};
    if (!run.recording.isEmpty())
        run.ended = QFileInfo(run.recording).lastModified(); // it was written until the end
    const QStringList opened = linksOfStart();
    for (const QString &url : left->links)
        if (!opened.contains(url))
            run.links << url;
    if (!run.recording.isEmpty() || !run.links.isEmpty())
        m_window->offerRescue(run);
}

/// Takes the place of the links, so that it starts only while none is in use.
void Application::startDemo()
{
    if (m_demo)
        return;
    if (const QString reason = ui::demoDisabledReason(m_window->view()); !reason.isEmpty()) {
        m_window->reportProblem(reason);
        return;
    }
    auto demo = Demo::create(m_random);
    if (!demo) {
        m_window->reportProblem(engine::reasonText(demo.error().reason()));
        return;
    }
    m_demo = std::move(*demo);
    keepLinks();
    m_question.withdraw();
    m_station->exchange(configOf(m_window->settings(), m_demo->stationKeys()));
    m_keyProblem.clear();
    useKeys(m_demo->stationKeys());
    beginDemo();
}

/// Returns to the keys and links of the user.
void Application::endDemo()
{
    if (!m_demo)
        return;
    m_demoFlight.reset();
    auto demo = std::move(m_demo); // the station records into its folder until the exchange
    m_window->setDemo(false);
    m_keyProblem.clear();
    const engine::KeyPaths keys = chooseKeys();
    const bool locked = isLocked(keys);
    exchangeStation(locked ? engine::KeyPaths() : keys);
    if (locked)
        m_keyProblem = engine::reasonText(PassphraseQuestion::notGiven(keys.identity).reason());
    demo.reset();
    useKeys(keys);
    openKeyAndLinks(locked);
}

/// The vehicle of the demo is met on a port of its own on loopback, unless the command line names links.
void Application::beginDemo()
{
    connect(m_demo.get(), &Demo::ended, m_window.get(), [this](const QString &problem) {
        m_window->reportProblem(problem, tr("Restart the demo"), [this] {
            if (m_demo)
                m_demo->restart();
        });
    });
    m_window->setDemo(true);
    const bool named = m_options.demo && !m_options.links.empty();
    const link::LinkUrl url = named ? m_options.links.front()
                                    : *link::LinkUrl::parse("udpin:127.0.0.1:" + std::to_string(link::freeUdpPorts(1).front()));
    if (named)
        for (const QString &own : linksOfStart())
            m_window->addLink(own);
    else
        m_window->addLink(QString::fromStdString(url.toText()));
    m_demo->start(url.traits().isDatagramServer() && url.port() != 0 ? url.port() : kUsualPort);
    m_demoFlight = std::make_unique<DemoFlight>(*m_station);
}

void Application::stop()
{
    if (m_window && m_window->isVisible())
        m_window->quit();
    else
        QApplication::closeAllWindows();
}

void Application::followLink(const link::LinkUrl &url)
{
    if (!m_demo && !m_keptLinks.isEmpty())
        m_keptLinks << QString::fromStdString(url.toText()); // added while the others wait for the key
    // If the port was in use, the operator listens on another one: the demo's agent follows.
    if (m_demo && url.traits().isDatagramServer() && url.port() != 0)
        m_demo->start(url.port());
}

/// Again and again until the child that measured them has ended.
void Application::collectHeapFigures()
{
    constexpr int kEvery = 500; // milliseconds
    if (m_heap && !m_heap->collectIfDone())
        QTimer::singleShot(kEvery, this, &Application::collectHeapFigures);
}

void Application::takeScreenshot()
{
    const QString problem = ui::writeImage(m_options.screenshot, m_window->grab().toImage());
    if (!problem.isEmpty())
        complain(kName, problem.toStdString());
    QCoreApplication::exit(problem.isEmpty() ? kDone : kCannotOpen);
}

} // namespace skyseal::app

#include "moc_application.cpp"
