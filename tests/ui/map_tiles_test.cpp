// The window's map with pictures: chosen by real input, from a tile server on loopback and from a file.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "tile_server.h"
#include "ui/map/map_view.h"
#include "window_rig.h"

#include <QtCore/QTimer>
#include <QtGui/QAction>
#include <QtGui/QWheelEvent>
#include <QtTest/QTest>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QSpinBox>

using namespace skyseal;
using namespace skyseal::ui;

class MapTilesTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_server = std::make_unique<TileServer>();
        m_server->answer = [](const QString &) { return TileServer::Answer{200, tileBytes(Qt::magenta)}; };
        ProgramFacts facts;
        facts.version = QStringLiteral("9.8.7");
        setUp(facts);
        m_station->showSealed(1);
    }
    void cleanup()
    {
        tearDown();
        m_server.reset();
    }

    void nothingIsRequestedBeforeTheOperatorAgrees()
    {
        typeAddress();
        QCOMPARE(find<QLabel>("mapSourceState")->text(), QStringLiteral("Tiles will be requested from 127.0.0.1"));
        QTest::keyClick(find<QDialog>("mapSourceDialog"), Qt::Key_Escape);
        m_station->showSealed(2);
        map()->repaint();
        QCOMPARE(m_server->mostOpen, 0);
        QVERIFY(!map()->tiles().isOn());
    }

    void tilesOfTheChosenServerAreShown()
    {
        choose();
        EVENTUALLY(isShown(Qt::magenta));
        QVERIFY(m_server->mostOpen <= 2);
        QCOMPARE(m_server->agents.first(), QStringLiteral("Skyseal/9.8.7"));
        QCOMPARE(map()->tiles().attribution(), QStringLiteral("© test"));
        const auto asked = m_server->paths.size();
        open(); // the choice stays
        m_station->showSealed(3);
        EVENTUALLY(isShown(Qt::magenta));
        QVERIFY(m_server->paths.size() > asked);
    }

    void incompleteAddressesAreNotAccepted()
    {
        openDialog();
        QTest::mouseClick(find<QRadioButton>("mapSourceServer"), Qt::LeftButton, {}, {8, 8});
        auto *ok = find<QDialog>("mapSourceDialog")->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        QVERIFY(!ok->isEnabled() && !ok->toolTip().isEmpty());
        QTest::keyClicks(find<QLineEdit>("mapSourceUrl"), QStringLiteral("https://tile.example.org/{z}/{x}"));
        QVERIFY(!ok->isEnabled());
        QTest::keyClicks(find<QLineEdit>("mapSourceUrl"), QStringLiteral("/{y}.png"));
        QVERIFY(ok->isEnabled());
    }

    /// The wheel moves the map in small steps, and finally by half a level a notch, around the pointer.
    void wheelZoomsSmoothlyAroundThePointer()
    {
        const QPointF pointer(300, 200);
        const QPointF under = map()->viewport().toMetres(pointer);
        const double before = map()->viewport().zoomLevel();
        int steps = 0;
        double last = before;
        QTimer look; // between any two other timers
        connect(&look, &QTimer::timeout, this, [&] {
            steps += map()->viewport().zoomLevel() != last;
            last = map()->viewport().zoomLevel();
        });
        look.start(0);
        QWheelEvent notch(pointer, map()->mapToGlobal(pointer), {}, {0, 240}, {}, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(map(), &notch);
        EVENTUALLY(qAbs(last - before - 1) < 1e-6);
        QVERIFY2(steps >= 2, qPrintable(QString::number(steps))); // many, unless the machine is busy; but not in one
        QVERIFY((map()->viewport().toPixels(under) - pointer).manhattanLength() < 1e-3);
    }

    void keysMoveAndZoomTheMap()
    {
        QTest::mouseClick(map(), Qt::LeftButton, {}, {200, 200});
        const double before = map()->viewport().zoomLevel();
        QTest::keyClick(map(), Qt::Key_Plus);
        EVENTUALLY(map()->viewport().zoomLevel() > before + 0.5);
        const QPointF centre = map()->viewport().centre();
        QTest::keyClick(map(), Qt::Key_Right);
        EVENTUALLY(map()->viewport().centre().x() > centre.x());
        QVERIFY(!map()->isFollowing());
        QTest::keyClick(map(), Qt::Key_Home);
        QVERIFY(map()->isFollowing());
    }

    void memoryOfTilesIsBounded()
    {
        choose();
        EVENTUALLY(isShown(Qt::magenta));
        while (m_server->paths.size() < 160) { // more than are kept
            const auto asked = m_server->paths.size();
            QTest::mousePress(map(), Qt::LeftButton, {}, {400, 300});
            QTest::mouseMove(map(), {20, 20});
            QTest::mouseRelease(map(), Qt::LeftButton, {}, {20, 20});
            EVENTUALLY(m_server->paths.size() > asked);
        }
        EVENTUALLY(isShown(Qt::magenta));
        QVERIFY(map()->tiles().keptKilobytes() <= TileLayer::kKeptKilobytes);
    }

    void problemsOfTheServerAreSaid()
    {
        m_server->answer = [](const QString &) { return TileServer::Answer{403}; };
        choose();
        EVENTUALLY(!map()->tiles().problem().isEmpty());
        const QString said = map()->tiles().problem();
        QVERIFY2(said.startsWith(QStringLiteral("no tile could be downloaded: ")), qPrintable(said));
    }

    void areaInViewIsFetchedAndUsed()
    {
        choose();
        EVENTUALLY(isShown(Qt::magenta));
        trigger("menuView", "actionFetchArea");
        auto *dialog = find<QDialog>("regionDialog");
        auto *path = find<QLineEdit>("regionPath");
        path->selectAll();
        const QString file = m_folder->filePath(QStringLiteral("area.mbtiles"));
        QTest::keyClicks(path, file);
        find<QSpinBox>("regionTo")->setValue(find<QSpinBox>("regionFrom")->value());
        QTest::mouseClick(find<QPushButton>("regionStart"), Qt::LeftButton);
        auto *use = find<QPushButton>("regionUse");
        EVENTUALLY(use->isEnabled());
        QVERIFY(QFile::exists(file));
        QTest::mouseClick(use, Qt::LeftButton);
        EVENTUALLY(!dialog->isVisible());
        QVERIFY(map()->tiles().source().kind == MapSource::Kind::File);
        m_server->close();
        EVENTUALLY(isShown(Qt::magenta));
        QCOMPARE(m_window->settings().map.file, file);
    }

    void cancelledAreaLeavesNoFile()
    {
        choose();
        EVENTUALLY(isShown(Qt::magenta));
        trigger("menuView", "actionFetchArea");
        auto *path = find<QLineEdit>("regionPath");
        path->selectAll();
        const QString file = m_folder->filePath(QStringLiteral("area.mbtiles"));
        QTest::keyClicks(path, file);
        find<QSpinBox>("regionFrom")->setValue(12);
        const auto asked = m_server->paths.size();
        QTest::mouseClick(find<QPushButton>("regionStart"), Qt::LeftButton);
        EVENTUALLY(m_server->paths.size() > asked);
        QTest::mouseClick(find<QPushButton>("regionCancel"), Qt::LeftButton);
        EVENTUALLY(find<QLabel>("regionState")->text().startsWith(QStringLiteral("Cancelled")));
        QVERIFY(!QFile::exists(file) && !QFile::exists(file + QStringLiteral(".part")));
    }

    void areaNeedsAServerThatPermitsIt()
    {
        trigger("menuView", "actionFetchArea");
        QVERIFY(!find<QPushButton>("regionStart")->isEnabled());
        QVERIFY(find<QLabel>("regionState")->text().contains(QStringLiteral("tile server")));
    }

private:
    MapView *map() const { return find<MapView>("map"); }

    void openDialog() { QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier); }

    void typeAddress()
    {
        openDialog();
        QTest::mouseClick(find<QRadioButton>("mapSourceServer"), Qt::LeftButton, {}, {8, 8});
        QTest::keyClicks(find<QLineEdit>("mapSourceUrl"), m_server->address());
        QTest::keyClicks(find<QLineEdit>("mapSourceAttribution"), QStringLiteral("© test"));
    }

    void choose()
    {
        typeAddress();
        QTest::keyClick(find<QDialog>("mapSourceDialog"), Qt::Key_Return);
    }

    void trigger(const char *menuName, const char *actionName)
    {
        auto *menu = find<QMenu>(menuName);
        auto *bar = m_window->menuBar();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(menu->menuAction()).center());
        EVENTUALLY(menu->isVisible());
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(find<QAction>(actionName)).center());
    }

    /// Tiles of this colour are on the picture, away from everything that is drawn above them.
    bool isShown(const QColor &color) const
    {
        const QImage picture = map()->grab().toImage();
        int found = 0;
        for (int x = 10; x < picture.width(); x += 20)
            found += picture.pixelColor(x, picture.height() / 2 + 60) == color;
        return found > picture.width() / 20 * 3 / 4;
    }

    std::unique_ptr<TileServer> m_server;
};

SKYSEAL_TEST_WIDGETS(MapTilesTest)
#include "map_tiles_test.moc"
