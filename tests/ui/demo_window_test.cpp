// The demo in the program's own window: it never takes the place of a vehicle, it is marked as long as it lasts, and afterwards
// the user's keys, links and files are as before. Pictures are kept in the folder that SKYSEAL_PICTURES names.
#include "sealed_window.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"
#include "ui/window/source_bar.h"

#include <QtCore/QDir>
#include <QtTest/QTest>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class DemoWindowTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("PATH", QByteArray(SKYSEAL_BIN_DIR) + ':' + qgetenv("PATH")); }
    void init() { m_it = std::make_unique<SealedWindow>(); }
    void cleanup() { m_it.reset(); }

    void neverTakesThePlaceOfALiveVehicle();
    void isMarkedAndLeavesEverythingAsBefore();
    void startedByTheCommandLineEndsToo();
    void endsWithTheWindow();

private:
    bool isMarked() const
    {
        return m_it->find<SourceBar>("sourceBar")->isVisible()
            && m_it->find<QLabel>("sourceTitle")->text().startsWith(QStringLiteral("DEMO: "))
            && m_it->window->windowTitle() == QStringLiteral("Skyseal: demo");
    }
    bool demoFlies() const
    {
        return m_it->view().session && m_it->strip("stripLock").contains(QStringLiteral("air-demo ✓")) && m_it->view().vehicle
            && m_it->vehicle().altitudeRelative > 2;
    }
    /// The URLs of the links, sorted.
    QStringList links() const
    {
        QStringList out;
        if (m_it->view().snapshot)
            for (const engine::LinkSnapshot &link : m_it->view().snapshot->links)
                out << QString::fromStdString(link.url);
        out.sort();
        return out;
    }
    /// The files of the user, with their content, except recordings.
    QMap<QString, QByteArray> files() const
    {
        QMap<QString, QByteArray> out;
        const QDir data(m_it->path("XDG_DATA_HOME") + QStringLiteral("/skyseal/skyseal"));
        for (const QString &name : data.entryList(QDir::Files)) {
            QFile file(data.filePath(name));
            if (file.open(QIODevice::ReadOnly))
                out.insert(name, file.readAll());
        }
        return out;
    }

    QStringList recordings() const
    {
        return QDir(m_it->path("XDG_DATA_HOME") + QStringLiteral("/skyseal/skyseal/logs")).entryList(QDir::Files);
    }

    std::unique_ptr<SealedWindow> m_it;
};

void DemoWindowTest::neverTakesThePlaceOfALiveVehicle()
{
    QVERIFY(m_it->open({m_it->groundLink()}));
    m_it->startVehicles();
    m_it->startAgent();
    EVENTUALLY(m_it->isReadyToFly());
    const auto session = m_it->view().session->info.session;
    auto *start = m_it->find<QAction>("actionDemo");
    EVENTUALLY(!start->isEnabled());
    QCOMPARE(start->toolTip(), QStringLiteral("A vehicle is connected: the demo would end its link"));
    QVERIFY(!m_it->find<QAction>("actionEndDemo")->isEnabled());
    // Neither if the wish comes from elsewhere, as when the vehicle is heard while the button is pressed.
    Q_EMIT m_it->window->demoRequested();
    EVENTUALLY_EQUAL(m_it->find<QLabel>("problemText")->text(),
                     QStringLiteral("A vehicle is connected: the demo would end its link"));
    const std::uint64_t now = m_it->view().snapshot->number;
    EVENTUALLY(m_it->view().snapshot->number > now + 30);
    QVERIFY(!isMarked());
    QVERIFY(m_it->isSealed() && m_it->view().session->info.session == session);

    // A vehicle that has gone silent is still the operator's.
    QCOMPARE(m_it->air->terminate(), 0);
    EVENTUALLY(!m_it->view().session);
    m_it->sim->kill();
    EVENTUALLY(m_it->vehicle().messageAge > 3.5);
    QVERIFY(!start->isEnabled());
    Q_EMIT m_it->window->demoRequested();
    QVERIFY(!isMarked());
}

void DemoWindowTest::isMarkedAndLeavesEverythingAsBefore()
{
    const quint16 other = test::freeUdpPort();
    QVERIFY(m_it->open({m_it->groundLink()}));
    m_it->window->addLink(QStringLiteral("udpin:127.0.0.1:%1").arg(other)); // as by the dialog
    EVENTUALLY_EQUAL(links().size(), 2);
    const QStringList linksBefore = links();
    const auto filesBefore = files();
    const QStringList recordingsBefore = recordings();
    m_it->hands->choose("menuTools", "actionDemo");
    EVENTUALLY(isMarked());
    QVERIFY(m_it->flies([this] { return demoFlies(); })); // takes off by itself
    QVERIFY(isMarked());
    QVERIFY2(!links().contains(linksBefore[0]) && !links().contains(linksBefore[1]),
             qPrintable(links().join(QLatin1Char(' '))));
    EVENTUALLY(m_it->view().snapshot->recording.bytes > 0);
    const QString recording = QString::fromStdString(m_it->view().snapshot->recording.file);
    QVERIFY(QFile::exists(recording));
    QCOMPARE(recordings(), recordingsBefore); // those of the user
    QVERIFY(!m_it->find<QAction>("actionDemo")->isEnabled());
    QCOMPARE(m_it->find<QAction>("actionDemo")->toolTip(), QStringLiteral("The demo is running"));
    for (const char *workspace : {"workspace_plan", "workspace_vehicle", "workspace_lab", "workspace_fly"}) {
        m_it->show(workspace);
        QVERIFY(isMarked()); // in each
        m_it->hands->picture(QStringLiteral("demo-%1").arg(QLatin1String(workspace)));
    }

    m_it->hands->click("sourceEnd");
    EVENTUALLY(!m_it->find<SourceBar>("sourceBar")->isVisible());
    QCOMPARE(m_it->window->windowTitle(), QStringLiteral("Skyseal"));
    EVENTUALLY_EQUAL(links(), linksBefore);
    EVENTUALLY(!m_it->view().vehicle && !m_it->view().session);
    EVENTUALLY(!m_it->window->findChild<MapView *>()->content().vehicle()); // the copter of the demo
    QCOMPARE(files(), filesBefore);
    QVERIFY2(!QFile::exists(recording), qPrintable(recording));
    EVENTUALLY(m_it->find<QAction>("actionDemo")->isEnabled());
    QVERIFY(!m_it->find<QAction>("actionEndDemo")->isEnabled());
    m_it->hands->picture(QStringLiteral("demo-ended"));

    // The user's own vehicle meets the user's own key, on the user's link.
    m_it->startVehicles();
    m_it->startAgent();
    EVENTUALLY(m_it->isReadyToFly());
    QVERIFY(!m_it->vehicle().armed); // another one
}

void DemoWindowTest::startedByTheCommandLineEndsToo()
{
    app::WindowOptions options;
    options.demo = true;
    QVERIFY(m_it->open(std::move(options)));
    QVERIFY(isMarked());
    QVERIFY(m_it->flies([this] { return demoFlies(); }));
    m_it->hands->choose("menuTools", "actionEndDemo");
    EVENTUALLY(!m_it->find<SourceBar>("sourceBar")->isVisible());
    EVENTUALLY(!m_it->view().vehicle && !m_it->view().session);
    EVENTUALLY_EQUAL(links(), QStringList{m_it->window->settings().defaultLink});
    QVERIFY(files().contains(QStringLiteral("identity.key"))); // the user has a key now, and no longer the demo's
    EVENTUALLY(m_it->find<QAction>("actionDemo")->isEnabled());
}

/// Its programs do not outlive the window, nor do its keys.
void DemoWindowTest::endsWithTheWindow()
{
    const auto demoFolders = [] {
        QStringList out;
        const QDir temporary(QDir::tempPath());
        for (const QString &name : temporary.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            if (QFile::exists(temporary.filePath(name + QStringLiteral("/station.key"))))
                out << name;
        return out;
    };
    const QTemporaryDir ownTemporary;
    qputenv("TMPDIR", ownTemporary.path().toUtf8());
    app::WindowOptions options;
    options.demo = true;
    QVERIFY(m_it->open(std::move(options)));
    EVENTUALLY(m_it->view().session && m_it->view().vehicle);
    QCOMPARE(demoFolders().size(), 1);
    const auto children = [] {
        QFile list(QStringLiteral("/proc/self/task/%1/children").arg(QCoreApplication::applicationPid()));
        return list.open(QIODevice::ReadOnly) ? list.readAll().split(' ').size() - 1 : -1;
    };
    QCOMPARE(children(), 2);
    m_it->close();
    QCOMPARE(children(), 0);
    QVERIFY(demoFolders().isEmpty());
}

SKYSEAL_TEST_WIDGETS(DemoWindowTest)
#include "demo_window_test.moc"
