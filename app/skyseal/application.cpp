#include "app/skyseal/application.h"

#include "app/common/options.h"
#include "core/channel/policy.h"
#include "app/skyseal/own_files.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QTimer>
#include <QtGui/QPixmap>

namespace skyseal::app {

namespace {

constexpr quint16 kUsualPort = 14550;

const QString kName = QStringLiteral("skyseal");

} // namespace

Application::Application(WindowOptions options, RandomSource &random) : m_options(std::move(options)), m_random(random) {}

Application::~Application()
{
    // The window first: it uses the station until it is gone.
    m_window.reset();
    m_demoFlight.reset();
    m_demo.reset();
    m_station.reset();
}

engine::StationConfig Application::configOf(const ui::Settings &settings, engine::KeyPaths keys) const
{
    engine::StationConfig config;
    config.systemId = static_cast<std::uint8_t>(settings.systemId);
    config.componentId = static_cast<std::uint8_t>(settings.componentId);
    config.secure = settings.requireSealed ? engine::SecureMode::Required : engine::SecureMode::Preferred;
    config.keys = std::move(keys);
    config.policy.suites = channel::defaultSuites();
    config.policy.allowResearch = settings.allowResearch;
    config.record = settings.record;
    config.recordFolder = (settings.recordFolder.isEmpty() ? defaultRecordFolder() : settings.recordFolder).toStdString();
    return config;
}

engine::KeyPaths Application::chooseKeys()
{
    if (!m_options.identityFile.empty())
        return {m_options.identityFile, m_options.peersFile};
    auto own = ownKeys(m_random);
    if (own)
        return *own;
    m_keyProblem = QString::fromStdString(own.error().text());
    return {};
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
    if (!station && m_options.identityFile.empty() && !m_options.demo) {
        // A damaged key of one's own must not keep the window away: it opens for plain links and says so.
        m_keyProblem = QString::fromStdString(station.error().text());
        station = engine::Station::create(configOf(settings, {}));
    }
    if (!station) {
        complain(kName, station.error().text());
        return false;
    }
    m_station = std::make_unique<StationAdapter>(std::move(*station));
    makeWindow();
    m_window->show();
    openLinks();
    if (m_demo)
        beginDemo();
    if (!m_keyProblem.isEmpty())
        m_window->tellProblem(tr("No sealed links: %1").arg(m_keyProblem));
    if (!m_options.screenshot.isEmpty())
        QTimer::singleShot(qRound(m_options.screenshotAfter * 1000), this, &Application::takeScreenshot);
    return true;
}

void Application::makeWindow()
{
    ui::ProgramFacts facts;
    facts.version = QCoreApplication::applicationVersion();
    facts.identityFile = m_options.identityFile.empty() ? dataFolder() + QStringLiteral("/identity.key")
                                                        : QString::fromStdString(m_options.identityFile);
    facts.peersFile =
        m_options.peersFile.empty() ? dataFolder() + QStringLiteral("/peers") : QString::fromStdString(m_options.peersFile);
    facts.recordFolder = defaultRecordFolder();
    facts.demoAvailable = Demo::isAvailable();
    m_window = std::make_unique<ui::MainWindow>(*m_station, m_store, std::move(facts));
    connect(m_station.get(), &StationAdapter::failed, m_window.get(),
            [this](const QString &problem) { m_window->tellProblem(problem); });
    connect(m_station.get(), &StationAdapter::linkAdded, this, &Application::followLink);
    connect(m_window.get(), &ui::MainWindow::demoWanted, this, [this] {
        if (m_demo)
            return;
        auto demo = Demo::create(m_random);
        if (!demo) {
            m_window->tellProblem(QString::fromStdString(demo.error().text()));
            return;
        }
        m_demo = std::move(*demo);
        m_station->exchange(configOf(m_window->settings(), m_demo->stationKeys()));
        openLinks();
        beginDemo();
    });
}

void Application::openLinks()
{
    if (m_options.links.empty())
        m_window->addLink(m_window->settings().defaultLink);
    for (const link::LinkUrl &url : m_options.links)
        m_window->addLink(QString::fromStdString(url.toText()));
}

void Application::beginDemo()
{
    connect(m_demo.get(), &Demo::ended, m_window.get(), [this](const QString &problem) {
        m_window->tellProblem(problem, tr("Start it again"), [this] { m_demo->restart(); });
    });
    quint16 port = kUsualPort;
    const auto url = m_options.links.empty() ? link::LinkUrl::parse(m_window->settings().defaultLink.toStdString())
                                             : m_options.links.front();
    if (url && url->scheme() == link::LinkScheme::UdpIn && url->port() != 0)
        port = url->port();
    m_demo->start(port);
    m_demoFlight = std::make_unique<DemoFlight>(*m_station);
}

void Application::followLink(const link::LinkUrl &url)
{
    // The operator listens elsewhere because the port was taken: the demo's agent follows.
    if (m_demo && url.scheme() == link::LinkScheme::UdpIn && url.port() != 0)
        m_demo->start(url.port());
}

void Application::takeScreenshot()
{
    const bool saved = m_window->grab().save(m_options.screenshot);
    if (!saved)
        complain(kName, m_options.screenshot.toStdString() + ": the picture could not be written");
    QCoreApplication::exit(saved ? 0 : 1);
}

} // namespace skyseal::app
