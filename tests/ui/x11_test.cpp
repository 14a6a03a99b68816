// The window under a real X server with a window manager, by keys and clicks that the server itself makes: focus, held keys and
// the windows of dialogs differ there from what QTest sends. Xvfb, blackbox and xdotool are in packaging/dependencies. Pictures
// are kept in the folder that SKYSEAL_PICTURES names.
#include "tests/support/eventually.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "ui/held_keys.h"
#include "window_rig.h"

#include <QtCore/QDir>
#include <QtCore/QProcess>
#include <QtGui/QAction>
#include <QtGui/QScreen>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QToolButton>

#include <csignal>
#include <sys/prctl.h>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

constexpr const char *kInside = "SKYSEAL_TEST_X_SERVER";

/// Counts the presses of the space bar that reach a widget.
/// Counts before any other filter of the program can take a press away.
class SpaceCounter : public QObject
{
public:
    explicit SpaceCounter(QObject &watched) : m_watched(watched) { qApp->installEventFilter(this); }
    int presses = 0;

    bool eventFilter(QObject *receiver, QEvent *event) override
    {
        presses += receiver == &m_watched && event->type() == QEvent::KeyPress
            && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Space;
        return false;
    }

private:
    QObject &m_watched;
};

} // namespace

class X11Test : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanup();
    void programOpensItsWindows();
    void heldSpaceCommandsNothingElsewhere();
    void alertsAreReachedAfterAMenu();
    void demoFlies();

private:
    /// The output of xdotool; the test fails if it does.
    QString xdo(const QStringList &arguments);
    void key(const char *keys) { xdo({QStringLiteral("key"), QStringLiteral("--clearmodifiers"), QLatin1String(keys)}); }
    /// Ids of the visible windows with this title. Qt adds the name of the program to those of dialogs.
    QStringList windows(const QString &title)
    {
        QProcess search;
        search.start(QStringLiteral("xdotool"),
                     {QStringLiteral("search"), QStringLiteral("--onlyvisible"), QStringLiteral("--name"),
                      QStringLiteral("^%1( .* Skyseal)?$").arg(title)});
        search.waitForFinished(test::kDeadlineMs);
        return QString::fromUtf8(search.readAllStandardOutput()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    }
    /// The title of the window that has the keyboard.
    QString active()
    {
        return xdo({QStringLiteral("getactivewindow"), QStringLiteral("getwindowname")})
            .trimmed()
            .section(QStringLiteral(" — "), 0, 0);
    }
    void activate(const QString &id) { xdo({QStringLiteral("windowactivate"), QStringLiteral("--sync"), id}); }
    /// 0: the whole screen.
    static QImage screen(WId window = 0) { return QGuiApplication::primaryScreen()->grabWindow(window).toImage(); }
    static void picture(const char *name)
    {
        const QString folder = qEnvironmentVariable("SKYSEAL_PICTURES");
        if (!folder.isEmpty())
            QVERIFY(screen().save(QDir(folder).filePath(QLatin1String(name) + QStringLiteral(".png"))));
    }
    static void move(const QWidget &to, X11Test &by)
    {
        const QPoint place = to.mapToGlobal(to.rect().center());
        by.xdo({QStringLiteral("mousemove"), QString::number(place.x()), QString::number(place.y())});
    }
};

void X11Test::initTestCase()
{
    SKYSEAL_REQUIRES("x_server");
    QCOMPARE(QGuiApplication::platformName(), QStringLiteral("xcb"));
}

void X11Test::cleanup()
{
    if (m_window) {
        xdo({QStringLiteral("keyup"), QStringLiteral("space")});
        tearDown();
    }
}

QString X11Test::xdo(const QStringList &arguments)
{
    QProcess tool;
    tool.start(QStringLiteral("xdotool"), arguments);
    if (!test::eventually([&] { return tool.state() == QProcess::NotRunning; }) || tool.exitCode() != 0)
        QTest::qFail(qPrintable(arguments.join(QLatin1Char(' ')) + QString::fromLocal8Bit(tool.readAllStandardError())),
                     __FILE__, __LINE__);
    return QString::fromUtf8(tool.readAllStandardOutput());
}

/// The real program, by the keys of its menus: its dialogs are windows of their own, which take the keyboard and give it back.
void X11Test::programOpensItsWindows()
{
    const QTemporaryDir home;
    QProcess skyseal;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
        environment.insert(QLatin1String(folder), home.path());
    skyseal.setProcessEnvironment(environment);
    skyseal.setProcessChannelMode(QProcess::ForwardedChannels);
    skyseal.start(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal"), {QStringLiteral("--link"), QStringLiteral("udpin:127.0.0.1:0")});
    QVERIFY(skyseal.waitForStarted(test::kDeadlineMs));
    const QString name = QStringLiteral("Skyseal");
    EVENTUALLY(!windows(name).isEmpty());
    const QString window = windows(name).front();
    activate(window);
    EVENTUALLY_EQUAL(active(), name);
    picture("x11-start");

    const struct
    {
        const char *keys;
        QString title;
    } dialogs[] = {{"F1", QStringLiteral("Help")},
                   {"ctrl+k", QStringLiteral("Find a command")},
                   {"F12", QStringLiteral("Connect")},
                   {"ctrl+o", QStringLiteral("Replay a log")}};
    for (const auto &dialog : dialogs) {
        key(dialog.keys);
        EVENTUALLY2(windows(dialog.title).size() == 1, dialog.keys);
        EVENTUALLY_EQUAL(active(), dialog.title);
        picture(qPrintable(QStringLiteral("x11-") + dialog.title.section(QLatin1Char(' '), 0, 0).toLower()));
        key("Escape");
        EVENTUALLY2(windows(dialog.title).isEmpty(), dialog.keys);
        EVENTUALLY_EQUAL(active(), name); // the keyboard returns by itself
    }

    // Text that is typed into the palette opens another dialog.
    key("ctrl+k");
    EVENTUALLY_EQUAL(active(), QStringLiteral("Find a command"));
    xdo({QStringLiteral("type"), QStringLiteral("connect")});
    key("Return");
    EVENTUALLY_EQUAL(active(), QStringLiteral("Connect"));
    key("Escape");
    EVENTUALLY_EQUAL(active(), name);

    // Without a vehicle the window stands still, so that a picture tells the workspaces apart.
    QList<QImage> seen;
    for (const char *keys : {"ctrl+2", "ctrl+3", "ctrl+4", "ctrl+1"}) {
        key(keys);
        QImage last;
        const auto stands = [&] {
            const QImage now = screen(window.toULongLong()); // without the clock of the window manager
            const bool same = now == last;
            last = now;
            return same && !seen.contains(now);
        };
        QVERIFY2(test::eventually(stands), keys);
        seen << last;
        picture(qPrintable(QStringLiteral("x11-workspace-") + QLatin1String(keys).right(1)));
    }
    key("ctrl+q");
    EVENTUALLY(skyseal.state() == QProcess::NotRunning);
    QCOMPARE(skyseal.exitStatus(), QProcess::NormalExit);
    QCOMPARE(skyseal.exitCode(), 0);
}

/// A space bar that was pressed elsewhere commands nothing where the focus goes meanwhile, however often the server repeats it;
/// a fresh press commands once.
void X11Test::heldSpaceCommandsNothingElsewhere()
{
    setUp();
    m_station->showSealed(1);
    auto *land = find<HoldButton>("landButton");
    EVENTUALLY(land->isEnabled());
    EVENTUALLY(m_window->isActiveWindow());
    find<QWidget>("map")->setFocus();
    SpaceCounter counter(*land);
    const auto repeats = [&] {
        const int before = counter.presses;
        return test::eventually([&] { return counter.presses > before + 20; });
    };

    xdo({QStringLiteral("keydown"), QStringLiteral("space")});
    move(*land, *this);
    xdo({QStringLiteral("click"), QStringLiteral("1")});
    EVENTUALLY(land->hasFocus());
    QVERIFY(repeats()); // the server does repeat it, and into the button
    QVERIFY(m_station->commands.empty());
    picture("x11-held-space");

    const QSignalSpy released(&HeldKeys::ofProgram(), &HeldKeys::released);
    xdo({QStringLiteral("keyup"), QStringLiteral("space")});
    EVENTUALLY(!released.isEmpty()); // a press that comes sooner goes on with the hold
    xdo({QStringLiteral("keydown"), QStringLiteral("space")});
    EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
    QVERIFY(repeats());
    QCOMPARE(m_station->commands.size(), std::size_t(1));
}

/// By the first key after a choice from a menu, whether that was by the mouse or by keys.
void X11Test::alertsAreReachedAfterAMenu()
{
    setUp();
    m_station->showSealed(1);
    m_station->showSealed(2, [](auto &state) { state.messageAge = 4.2; });
    EVENTUALLY(m_window->isActiveWindow());
    const auto *dismiss = find<QToolButton>("alertDismiss0");
    QVERIFY(dismiss->isVisible());
    const auto clickAt = [this](const QWidget &on, const QPoint &at) {
        const QPoint place = on.mapToGlobal(at);
        xdo({QStringLiteral("mousemove"), QString::number(place.x()), QString::number(place.y()), QStringLiteral("click"),
             QStringLiteral("1")});
    };
    auto *menu = find<QMenu>("menuView");
    for (const bool byMouse : {true, false}) {
        find<QWidget>("map")->setFocus();
        if (byMouse)
            clickAt(*m_window->menuBar(), m_window->menuBar()->actionGeometry(menu->menuAction()).center());
        else
            key("alt+i");
        EVENTUALLY(menu->isVisible());
        if (byMouse)
            clickAt(*menu, menu->actionGeometry(find<QAction>("actionZoomIn")).center());
        else
            key("i");
        EVENTUALLY(!menu->isVisible());
        key("ctrl+shift+a");
        EVENTUALLY(dismiss->hasFocus());
    }
}

/// The flight over the real sealed link, in the windows of this server.
void X11Test::demoFlies()
{
    QProcess flight;
    flight.setProcessChannelMode(QProcess::MergedChannels);
    flight.start(QStringLiteral(SKYSEAL_UI_TESTS), {QStringLiteral("demo_flight_test")});
    QVERIFY(flight.waitForFinished(-1)); // it has its own deadlines
    const QByteArray said = flight.readAll();
    QVERIFY2(flight.exitStatus() == QProcess::NormalExit && flight.exitCode() == 0, said.constData());
    QVERIFY2(said.contains("PASS   : DemoFlightTest::lands()"), said.constData());
}

/// Runs again inside an X server of its own with a window manager, whatever display there is.
static int runInServer(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QProcess server, manager, inside;
    for (QProcess *child : {&server, &manager, &inside}) // none outlives a test that is killed
        child->setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGTERM); });
    server.setReadChannel(QProcess::StandardOutput);
    server.start(QStringLiteral("Xvfb"),
                 {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"), QStringLiteral("0"),
                  QStringLiteral("1400x1000x24"), QStringLiteral("-nolisten"), QStringLiteral("tcp")});
    while (!server.canReadLine())
        if (!server.waitForReadyRead(test::kDeadlineMs))
            qFatal("Xvfb: %s", server.readAllStandardError().constData());
    const QTemporaryDir home; // the window manager's
    qputenv("DISPLAY", ':' + server.readLine().trimmed());
    qputenv("HOME", home.path().toUtf8());
    qputenv("QT_QPA_PLATFORM", "xcb");
    qputenv(kInside, "1");
    qunsetenv("WAYLAND_DISPLAY");
    manager.start(QStringLiteral("blackbox"));
    inside.setProcessChannelMode(QProcess::ForwardedChannels);
    inside.start(QCoreApplication::applicationFilePath(), QCoreApplication::arguments().mid(1));
    inside.waitForFinished(-1);
    for (QProcess *other : {&manager, &server}) {
        other->terminate();
        other->waitForFinished(test::kDeadlineMs);
    }
    return inside.exitStatus() == QProcess::NormalExit ? inside.exitCode() : 1;
}

SKYSEAL_TEST_ENTRY(X11Test,
                   if (!qEnvironmentVariableIsSet(kInside) && !test::lackOf("x_server")) return runInServer(argc, argv);
                   QApplication application(argc, argv);)

#include "x11_test.moc"
