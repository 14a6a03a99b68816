#include "app/skyseal/application.h"

#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "core/crypto/passphrase.h"
#include "core/channel/policy.h"
#include "core/channel/suite_strength.h"
#include "core/crypto/x25519.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/text/qt_text.h"
#include "core/keys/secret_file.h"
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

} // namespace

Application::Application(WindowOptions options, RandomSource &random, std::shared_ptr<experiment::HeapFigures> heap)
    : m_options(std::move(options)), m_random(random), m_heap(std::move(heap))
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
    const keys::AskPassphrase ask = m_options.passphrase.isGiven() ? m_options.passphrase.ask() : m_question.recalled();
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
    m_keyring.setProblem(m_keyProblem);
    m_window->setKeyProblem(m_keyProblem);
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

void Application::showKeyProblem()
{
    const auto facts = keys::readIdentityFacts(m_keys.identity);
    const QString text = tr("No sealed links: %1").arg(m_keyProblem);
    if (facts && facts->sealed)
        m_window->reportProblem(text, tr("Enter the passphrase"), [this] { askForPassphrase(); });
    else
        m_window->reportProblem(text);
}

void Application::askForPassphrase()
{
    m_question.ask(
        *m_window, m_keys.identity, [this](const PassphraseQuestion::Identity &identity) { useOpenedKeys(identity); },
        [this](const InputError &why) {
            m_keyProblem = engine::reasonText(why.reason());
            m_window->setKeyProblem(m_keyProblem);
            showKeyProblem();
        });
}

void Application::useOpenedKeys(const PassphraseQuestion::Identity &identity)
{
    m_keyProblem.clear();
    engine::KeyPaths keys = m_keys;
    keys.opened = identity;
    m_station->exchange(configOf(m_window->settings(), keys));
    useKeys(m_keys);
    openLinks();
}

/// Asks for what opens the key, or says why it cannot be used.
void Application::reportMissingKeys()
{
    if (m_keyProblem.isEmpty())
        return;
    if (m_question.isNeeded())
        askForPassphrase();
    else
        showKeyProblem();
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
    auto station = engine::Station::create(configOf(settings, keys));
    if (!station && !m_options.demo && (m_options.identityFile.empty() || m_question.isNeeded())) {
        // A damaged key or a missing passphrase must not prevent the window from opening: it opens for plain links, and asks or
        // reports the problem.
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
    if (m_demo)
        beginDemo();
    else {
        openLinks();
        offerRescue();
    }
    reportMissingKeys();
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

void Application::openLinks()
{
    if (m_options.links.empty())
        m_window->addLink(m_window->settings().defaultLink);
    for (const link::LinkUrl &url : m_options.links)
        m_window->addLink(QString::fromStdString(url.toText()));
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
    QStringList opened{m_window->settings().defaultLink};
    if (!m_options.links.empty())
        opened.clear();
    for (const link::LinkUrl &url : m_options.links)
        opened << QString::fromStdString(url.toText());
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
    if (const auto &snapshot = m_window->view().station()) {
        m_linksBeforeDemo.emplace();
        for (const engine::LinkSnapshot &link : snapshot->links)
            if (!link.listenOnly) // such a link needs its key as well
                *m_linksBeforeDemo << QString::fromStdString(link.url);
    }
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
    m_station->exchange(configOf(m_window->settings(), keys));
    if (!m_station->isRunning()) { // as at the start: plain links work without the key
        const auto identity = keys::readIdentityFacts(keys.identity);
        m_keyProblem = identity ? tr("the key could not be opened") : engine::reasonText(identity.error().reason());
        m_station->exchange(configOf(m_window->settings(), {}));
    }
    demo.reset();
    useKeys(keys);
    openLinksAgain();
    reportMissingKeys();
}

/// Those that the user had when the demo took their place, whether the operator or the command line opened them.
void Application::openLinksAgain()
{
    const auto before = std::exchange(m_linksBeforeDemo, {});
    if (!before)
        return openLinks();
    for (const QString &url : *before)
        m_window->addLink(url);
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
                                    : *link::LinkUrl::parse("udpin:127.0.0.1:" + std::to_string(Demo::freePort()));
    if (named)
        openLinks();
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
