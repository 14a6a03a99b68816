// What the window costs: a process that flies one vehicle over a map, how soon the program shows itself and ends, and the
// frames of the window with fifty vehicles, with a thousand map tiles and with the longest track. Needs no display; under a
// real one with QT_QPA_PLATFORM=xcb. The programs come from the same build. Exit status 1 if a limit is exceeded, which says
// something only on a machine that does nothing else.
#include "frame_meter.h"
#include "window_scene.h"

#include "app/skyseal/station_adapter.h"
#include "core/channel/policy.h"
#include "core/crypto/init_crypto.h"
#include "core/engine/station/snapshot.h"
#include "core/metrics/process_usage.h"
#include "tests/support/flight.h"
#include "ui/map/map_view.h"
#include "ui/map/track.h"
#include "ui/window/main_window.h"

#include <QtCore/QDateTime>
#include <QtCore/QDir>
#include <QtCore/QEventLoop>
#include <QtCore/QFileInfo>
#include <QtCore/QSettings>
#include <QtTest/QTest>

#include <cstdio>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr double kMostCpu = 3, kMostMegabytes = 100, kMostStartMs = 500, kMostQuitMs = 500, kMostFrameMs = 33;
constexpr double kMostMeanFrameMs = 16.7; // sixty a second
constexpr int kSceneSeconds = 15;
constexpr QSize kWindow(1366, 768);

bool failed = false;

void report(const char *what, double value, const char *unit, double limit)
{
    const bool over = value > limit;
    failed = failed || over;
    std::printf("  %-58s %8.1f %-4s limit %g%s\n", what, value, unit, limit, over ? "   EXCEEDED" : "");
    std::fflush(stdout);
}

void run(int milliseconds)
{
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
}

/// A field of smaps_rollup in megabytes.
double rollupMegabytes(qint64 pid, const QByteArray &field)
{
    QFile file(QStringLiteral("/proc/%1/smaps_rollup").arg(pid));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray &line : file.readAll().split('\n'))
        if (line.startsWith(field + ':'))
            return line.mid(field.size() + 1).simplified().split(' ').first().toDouble() / 1000;
    return 0;
}

/// The operator's settings: the map from this server, in the folder of one user.
void prepare(QSettings &store, const QString &tiles)
{
    store.setValue(QStringLiteral("map/source"), int(ui::MapSource::Kind::Server));
    store.setValue(QStringLiteral("map/url"), tiles);
    store.sync();
}

/// The real program, with files of its own.
class Skyseal
{
public:
    explicit Skyseal(const QString &tiles = {})
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char *folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
            environment.insert(QLatin1String(folder), m_home.path());
        m_process.setProcessEnvironment(environment);
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        if (!tiles.isEmpty()) {
            QSettings store(m_home.filePath(QStringLiteral("skyseal/skyseal.conf")), QSettings::IniFormat);
            prepare(store, tiles);
        }
    }
    ~Skyseal()
    {
        m_process.terminate();
        m_process.waitForFinished(kDeadlineMs);
    }
    /// As the desktop ends its programs. Returns how many milliseconds the program needed.
    double quit()
    {
        QElapsedTimer clock;
        clock.start();
        m_process.terminate();
        if (!m_process.waitForFinished(kDeadlineMs) || m_process.exitStatus() != QProcess::NormalExit)
            qFatal("the program does not quit");
        return static_cast<double>(clock.nsecsElapsed()) / 1e6;
    }
    void start(const QStringList &arguments) { m_process.start(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal"), arguments); }
    QString path(const QString &name) const { return m_home.filePath(name); }
    QProcess &process() { return m_process; }

private:
    QTemporaryDir m_home;
    QProcess m_process;
};

/// From the start of the program until a picture of its whole window has been written, which includes making the PNG.
void firstWindow()
{
    std::printf("The first window\n");
    std::vector<double> times;
    Skyseal program;
    for (int i = 0; i < 7; ++i) {
        const QString file = program.path(QStringLiteral("window%1.png").arg(i));
        const QDateTime begin = QDateTime::currentDateTimeUtc();
        program.start({QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:0"), QStringLiteral("--screenshot"), file,
                       QStringLiteral("--after"), QStringLiteral("0")});
        program.process().waitForFinished(kDeadlineMs);
        if (!QFileInfo::exists(file))
            qFatal("no picture of the window");
        times.push_back(static_cast<double>(begin.msecsTo(QFileInfo(file).lastModified())));
    }
    std::printf("  the very first start, which makes a key                    %8.1f ms\n", times.front());
    std::sort(times.begin() + 1, times.end());
    report("later starts, median of 6", times[4], "ms", kMostStartMs);
}

/// The program, an agent and the simulator, the link sealed: 50 telemetry messages a second besides the streams that the
/// station requests.
void oneVehicle(const QString &tiles)
{
    std::printf("One vehicle at 50 Hz, sealed, in Fly with tiles, %d s\n", kSceneSeconds);
    Flight flight;
    Skyseal program(tiles);
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments({QStringLiteral("--pps"), QStringLiteral("50")}));
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    program.start({QStringLiteral("--identity"), flight.path(QStringLiteral("ground.key")), QStringLiteral("--peers"),
                   flight.path(QStringLiteral("ground.peers")), QStringLiteral("--link"),
                   QStringLiteral("udpin:127.0.0.1:%1").arg(flight.groundPort)});
    if (air.waitFor(QStringLiteral("session")).isEmpty())
        qFatal("no session");
    run(5000); // the tiles of the first picture
    const qint64 pid = program.process().processId();
    const auto before = metrics::processCpuTime(pid), simBefore = metrics::processCpuTime(sim.pid());
    QElapsedTimer clock;
    clock.start();
    run(kSceneSeconds * 1000);
    const double wall = static_cast<double>(clock.elapsed()) / 1000;
    const auto percent = [wall](auto from, auto to) { return from && to ? 100 * seconds(*to - *from) / wall : 1e9; };
    report("CPU time of the program, of one core", percent(before, metrics::processCpuTime(pid)), "%", kMostCpu);
    std::printf("  that of the simulator                                      %8.1f %%\n",
                percent(simBefore, metrics::processCpuTime(sim.pid())));
    report("resident memory", rollupMegabytes(pid, "Rss"), "MB", kMostMegabytes);
    std::printf("  of that, its share of what processes have in common (Pss)  %8.1f MB; private %.1f MB\n",
                rollupMegabytes(pid, "Pss"), rollupMegabytes(pid, "Private_Dirty") + rollupMegabytes(pid, "Private_Clean"));
}

/// From the request to the end of the process, while a vehicle is connected over a sealed link and recorded.
void quitting()
{
    std::printf("The end of the program, one vehicle sealed and recorded\n");
    Flight flight;
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    std::vector<double> times;
    for (int i = 0; i < 7; ++i) {
        Skyseal program;
        program.start({QStringLiteral("--identity"), flight.path(QStringLiteral("ground.key")), QStringLiteral("--peers"),
                       flight.path(QStringLiteral("ground.peers")), QStringLiteral("--link"),
                       QStringLiteral("udpin:127.0.0.1:%1").arg(flight.groundPort)});
        const auto isUp = [](const QJsonObject &event) {
            return event[QLatin1String("state")].toString() == QLatin1String("up");
        };
        if (air.waitFor(QStringLiteral("session"), isUp).isEmpty())
            qFatal("no session");
        run(3000); // of flight, on the map and in the recording
        times.push_back(program.quit());
    }
    std::sort(times.begin(), times.end());
    report("time to quit, median of 7", times[3], "ms", kMostQuitMs);
    report("the longest", times.back(), "ms", kMostQuitMs);
}

/// The window in this process, with a real station.
class BenchWindow
{
public:
    explicit BenchWindow(const QString &tiles)
    {
        engine::StationConfig config;
        config.record = false;
        config.secure = engine::SecureMode::Off;
        config.policy.suites = channel::defaultSuites();
        auto station = engine::Station::create(config);
        if (!station)
            qFatal("%s", station.error().text().c_str());
        m_station = std::make_unique<app::StationAdapter>(std::move(*station));
        m_store = std::make_unique<QSettings>(m_folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        prepare(*m_store, tiles);
        ui::ProgramFacts facts;
        facts.cacheFolder = m_folder.filePath(QStringLiteral("tiles"));
        m_window = std::make_unique<ui::MainWindow>(*m_station, *m_store, facts);
        m_window->resize(kWindow);
        m_window->show();
        m_window->addLink(QStringLiteral("udpin:127.0.0.1:%1").arg(port));
    }
    ~BenchWindow() { m_window->quit(); }

    ui::MainWindow &operator*() { return *m_window; }
    ui::MapView &map() { return *m_window->findChild<ui::MapView *>(); }
    std::size_t vehicles() const { return m_window->view().snapshot ? m_window->view().snapshot->vehicles.size() : 0; }

    const quint16 port = freeUdpPort();

private:
    QTemporaryDir m_folder;
    std::unique_ptr<QSettings> m_store;
    std::unique_ptr<app::StationAdapter> m_station;
    std::unique_ptr<ui::MainWindow> m_window;
};

void reportFrames(const MeteredApplication &application, const char *where)
{
    std::printf("  %s: %zu frames, half within %.1f ms, 99 %% within %.1f ms\n", where, application.frames(),
                application.frameMs(0.5), application.frameMs(0.99));
    report("the worst frame", application.frameMs(1), "ms", kMostFrameMs);
    std::printf("  longest time without a pause                               %8.1f ms\n", application.worstStretchMs());
}

/// A drag over the whole width and back, and a level of zoom every two seconds.
class Mover
{
public:
    explicit Mover(ui::MapView &map) : m_map(map)
    {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { step(); });
        m_timer.start(16);
    }

private:
    void step()
    {
        const QPoint middle = m_map.rect().center();
        const int phase = m_step++ % 24; // 24 steps: one drag
        const QPoint place = middle + QPoint((phase - 12) * 25, (phase - 12) * (m_step / 240 % 2 == 0 ? 8 : -8));
        if (phase == 0)
            QTest::mousePress(&m_map, Qt::LeftButton, {}, place);
        else if (phase == 23)
            QTest::mouseRelease(&m_map, Qt::LeftButton, {}, place);
        else
            QTest::mouseMove(&m_map, place);
        if (m_step % 120 == 0)
            QTest::keyClick(&m_map, m_step / 120 % 4 < 2 ? Qt::Key_Minus : Qt::Key_Plus);
    }

    ui::MapView &m_map;
    QTimer m_timer;
    int m_step = 0;
};

void fiftyVehicles(MeteredApplication &application, const QString &tiles)
{
    std::printf("%d vehicles at %d Hz, %d s each\n", CirclingFleet::kVehicles, CirclingFleet::kHz, kSceneSeconds);
    BenchWindow window(tiles);
    const OnThread<CirclingFleet> fleet(window.port);
    if (!eventually([&] { return window.vehicles() == CirclingFleet::kVehicles; }))
        qFatal("%zu vehicles", window.vehicles());
    run(3000);
    for (const auto &[key, name] : {std::pair(Qt::Key_1, "Fly"), {Qt::Key_3, "Vehicle"}, {Qt::Key_4, "Lab"}}) {
        QTest::keyClick(&*window, key, Qt::ControlModifier);
        run(2000);
        application.restart();
        run(kSceneSeconds * 1000);
        reportFrames(application, name);
    }
}

void thousandTiles(MeteredApplication &application, MapServer &server)
{
    BenchWindow window(server.address());
    const OnThread<CirclingFleet> fleet(window.port);
    if (!eventually([&] { return window.vehicles() > 0; }))
        qFatal("no vehicle");
    run(3000);
    std::printf("1,000 map tiles of %.0f kB, the map dragged and zoomed, fifty vehicles on it\n",
                static_cast<double>(server.bytesEach()) / 1000);
    const int before = server.served();
    application.restart();
    QElapsedTimer clock;
    clock.start();
    {
        const Mover mover(window.map());
        while (server.served() < before + 1000 && clock.elapsed() < 2 * kDeadlineMs)
            run(100);
    }
    std::printf("  %d tiles in %.0f s\n", server.served() - before, static_cast<double>(clock.elapsed()) / 1000);
    reportFrames(application, "Fly");
}

/// A survey of parallel lanes, two metres between its points.
void flyTrack(ui::MainWindow &window, ui::MapView &map)
{
    engine::Snapshot snapshot = *window.view().snapshot;
    constexpr double kDegree = 111319.5;
    for (int i = 0; i < static_cast<int>(ui::Track::kMost); ++i) {
        const int lane = i / 250, along = lane % 2 ? 249 - i % 250 : i % 250;
        auto &state = snapshot.vehicles.front().state;
        state.position.latitude = 47.3977 + lane * 10 / kDegree;
        state.position.longitude = 8.5456 + along * 2 / kDegree / 0.677;
        map.showViewState(ui::viewOf(std::make_shared<const engine::Snapshot>(snapshot), state.systemId));
    }
}

void longTrack(MeteredApplication &application, const QString &tiles)
{
    BenchWindow window(tiles);
    const OnThread<CirclingFleet> vehicle(window.port, 1);
    if (!eventually([&] { return window.vehicles() > 0 && (*window).view().vehicle->state.position.known(); }))
        qFatal("no vehicle");
    flyTrack(*window, window.map());
    run(3000); // the tiles of the first picture
    std::printf("Pan and zoom with %zu track points over tiles, one vehicle at %d Hz, %d s\n", ui::Track::kMost,
                CirclingFleet::kHz, kSceneSeconds);
    application.restart();
    {
        const Mover mover(window.map());
        run(kSceneSeconds * 1000);
    }
    report("the mean frame", application.meanFrameMs(), "ms", kMostMeanFrameMs);
    reportFrames(application, "Fly");
}

} // namespace

/// Arguments choose scenes: start, quit, one, fifty, tiles, track. None: all.
int main(int argc, char **argv)
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    MeteredApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("skyseal"));
    if (!crypto::initCrypto())
        return 1;
    const QStringList scenes = QCoreApplication::arguments().mid(1);
    const auto wanted = [&scenes](const char *scene) { return scenes.isEmpty() || scenes.contains(QLatin1String(scene)); };
    OnThread<MapServer> server;
    std::printf("platform %s\n", qPrintable(QGuiApplication::platformName()));
    if (wanted("start"))
        firstWindow();
    if (wanted("quit"))
        quitting();
    if (wanted("one"))
        oneVehicle(server->address());
    if (wanted("fifty"))
        fiftyVehicles(application, server->address());
    if (wanted("tiles"))
        thousandTiles(application, *server);
    if (wanted("track"))
        longTrack(application, server->address());
    return failed ? 1 : 0;
}
