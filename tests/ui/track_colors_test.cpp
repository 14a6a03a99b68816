// The colours of the track: by the cipher suite, or by what the operator chooses in the menu, with a scale beside it.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"
#include "ui/map/track_scale.h"
#include "ui/theme/suite_style.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QMenu>

#include <cmath>
#include <limits>

using namespace skyseal;
using namespace skyseal::ui;

class TrackColorsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void stepsFollowTheValue()
    {
        Track track;
        for (int i = 0; i <= 10; ++i)
            track.append({i * 10.0, 0}, crypto::SuiteId::Aes256Gcm, {.altitude = static_cast<float>(i) * 5});
        const TrackScale scale(track, TrackColors::Altitude);
        QCOMPARE(scale.low(), 0.0);
        QCOMPARE(scale.high(), 50.0);
        QCOMPARE(scale.colorOf(track.points().front()), scale.colorOfStep(0));
        QCOMPARE(scale.colorOf(track.points().back()), scale.colorOfStep(TrackScale::kSteps - 1));
        QCOMPARE(scale.colorOf(track.points()[5]), scale.colorOfStep(2));
        for (int step = 1; step < TrackScale::kSteps; ++step)
            QVERIFY(scale.colorOfStep(step) != scale.colorOfStep(step - 1));
        const QColor unknown = TrackScale(track, TrackColors::Speed).colorOf(track.points().front());
        for (int step = 0; step < TrackScale::kSteps; ++step)
            QVERIFY(unknown != scale.colorOfStep(step));
    }

    void qualityHasAFixedRange()
    {
        Track track;
        track.append({0, 0}, crypto::SuiteId::Aes256Gcm, {.quality = 99.9f});
        track.append({10, 0}, crypto::SuiteId::Aes256Gcm, {.quality = 40});
        const TrackScale scale(track, TrackColors::LinkQuality);
        QCOMPARE(scale.low(), 80.0);
        QCOMPARE(scale.high(), 100.0);
        QCOMPARE(scale.colorOf(track.points().front()), scale.colorOfStep(TrackScale::kSteps - 1));
        QCOMPARE(scale.colorOf(track.points().back()), scale.colorOfStep(0));
    }

    void operatorChooses()
    {
        auto *map = find<MapView>("map");
        for (int i = 0; i < 60; ++i)
            m_station->showSealed(i);
        const QImage bySuite = map->grab().toImage();
        auto *menu = find<QMenu>("menuTrackColors");
        QVERIFY(menu);
        menu->popup({});
        auto *speed = menu->findChild<QAction *>(QStringLiteral("trackColors3"));
        QVERIFY(speed);
        QVERIFY(menu->findChild<QAction *>(QStringLiteral("trackColors0"))->isChecked());
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(speed).center());
        QCOMPARE(loadSettings(*m_store).trackColors, TrackColors::Speed);
        QVERIFY(map->grab().toImage() != bySuite);
        QCOMPARE(map->content().track().points().size() > 10, true);
        const TrackScale scale(map->content().track(), TrackColors::Speed);
        QVERIFY(std::isfinite(trackValue(map->content().track().points().back(), TrackColors::Speed)));
        QVERIFY(scale.high() > scale.low());
    }
};

SKYSEAL_TEST_WIDGETS(TrackColorsTest)
#include "track_colors_test.moc"
