// The part of the map that is shown, and the pointer that moves it, without a map.
#include "tests/support/test_runner.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_pointer.h"

#include <QtGui/QAction>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

const QPointF kFirstPosition = mercator::project({47.4, 8.5});

/// A camera of 400 by 300 pixels that has shown the first position of a vehicle.
struct FollowingCamera
{
    FollowingCamera()
    {
        camera.setAnimated(false);
        camera.setSize({400, 300});
        camera.showVehicle(kFirstPosition, true);
    }
    /// A new position, so many pixels to the right of the first.
    void fly(double pixels)
    {
        camera.showVehicle(kFirstPosition + QPointF(pixels * camera.viewport().metresPerPixel(), 0), true);
    }
    double centreOff() const
    {
        return (camera.viewport().centre().x() - kFirstPosition.x()) / camera.viewport().metresPerPixel();
    }

    MapCamera camera;
};

} // namespace

class MapCameraTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void firstVehicleIsShownFromNear()
    {
        MapCamera camera;
        const double far = camera.viewport().metresPerPixel();
        camera.setSize({400, 300});
        camera.showVehicle(kFirstPosition, true);
        QCOMPARE(camera.viewport().centre(), kFirstPosition);
        QVERIFY(camera.viewport().metresPerPixel() < far / 1000);
        QVERIFY(camera.isFollowing());
    }

    void followsInSteps()
    {
        FollowingCamera shown;
        QSignalSpy changed(&shown.camera, &MapCamera::changed);
        shown.fly(90);
        QCOMPARE(shown.centreOff(), 0.0);
        QCOMPARE(changed.size(), 0);
        shown.fly(110);
        QVERIFY(std::abs(shown.centreOff() - 110) < 0.01);
        QCOMPARE(changed.size(), 1);
    }

    void neitherFollowsNorTurnsWhileHeld()
    {
        FollowingCamera shown;
        shown.camera.rotation().action()->setChecked(true);
        shown.camera.hold();
        shown.fly(150);
        shown.camera.showHeading(90, 10);
        QCOMPARE(shown.centreOff(), 0.0);
        QCOMPARE(shown.camera.viewport().heading(), 0.0);
        shown.camera.letGo();
        shown.fly(150);
        shown.camera.showHeading(90, 10);
        QVERIFY(std::abs(shown.centreOff() - 150) < 0.01);
        QCOMPARE(shown.camera.viewport().heading(), 90.0);
    }

    void leavesTheVehicleWhenMoved_data()
    {
        QTest::addColumn<int>("how");
        QTest::newRow("drag") << 0;
        QTest::newRow("keys") << 1;
        QTest::newRow("fingers") << 2;
    }
    void leavesTheVehicleWhenMoved()
    {
        QFETCH(int, how);
        FollowingCamera shown;
        switch (how) {
        case 0: shown.camera.drag({-50, 0}); break;
        case 1: shown.camera.pan({-50, 0}); break;
        default: shown.camera.pinch({250, 150}, {200, 150}, 1); break;
        }
        QVERIFY(!shown.camera.isFollowing());
        QVERIFY(std::abs(shown.centreOff() - 50) < 0.01);
        shown.fly(1000);
        QVERIFY(std::abs(shown.centreOff() - 50) < 0.01);
        shown.camera.follow();
        QVERIFY(std::abs(shown.centreOff() - 1000) < 0.01);
    }

    void zoomKeepsFollowing()
    {
        FollowingCamera shown;
        const double before = shown.camera.viewport().metresPerPixel();
        shown.camera.zoom(2);
        QVERIFY(shown.camera.isFollowing());
        QVERIFY(std::abs(shown.camera.viewport().metresPerPixel() - before / 2) < 1e-9);
        QVERIFY(std::abs(shown.centreOff()) < 0.01);
    }

    void pointerTellsClicksFromDrags()
    {
        MapPointer pointer;
        QStringList heard;
        connect(&pointer, &MapPointer::dragBegan, this, [&] { heard += QStringLiteral("begin"); });
        connect(&pointer, &MapPointer::dragged, this, [&](const QPointF &by) { heard += QString::number(by.x()); });
        connect(&pointer, &MapPointer::dragEnded, this, [&] { heard += QStringLiteral("end"); });
        connect(&pointer, &MapPointer::clicked, this, [&] { heard += QStringLiteral("click"); });
        pointer.moveTo({5, 5}); // no button is down
        QCOMPARE(pointer.position(), std::optional(QPointF(5, 5)));
        pointer.press({10, 10});
        QVERIFY(pointer.isDragging());
        pointer.release({11, 10});
        QCOMPARE(heard.join(u' '), QStringLiteral("begin end click"));
        heard.clear();
        pointer.press({10, 10});
        pointer.moveTo({40, 10});
        pointer.moveTo({60, 10});
        pointer.release({60, 10});
        QCOMPARE(heard.join(u' '), QStringLiteral("begin 30 20 end"));
        QVERIFY(!pointer.isDragging());
        pointer.leave();
        QVERIFY(!pointer.position());
    }
};

SKYSEAL_TEST_WIDGETS(MapCameraTest)
#include "map_camera_test.moc"
