// Cost of the map's frames: CPU time of the window's thread while the map moves over a long track. The bound is a multiple of a
// reference drawing of the same size, painted in the same run, so that it holds on fast and slow machines; the milliseconds are
// printed.
#include "core/metrics/process_usage.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtGui/QPainter>
#include <QtTest/QTest>

#include <algorithm>
#include <cmath>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

constexpr QSize kSize(1600, 900);
constexpr int kPoints = 10'000;
/// Reference drawings that a frame may cost; measured 1.1. Not of a debug build.
[[maybe_unused]] constexpr double kFrameLimit = 2.5;
[[maybe_unused]] constexpr double kOverlayLimit = 20; ///< measured 8

double cpuMilliseconds()
{
    return 1000 * seconds(metrics::threadCpuTime());
}

struct Frames
{
    std::vector<double> costs; ///< milliseconds

    double at(double share) const
    {
        auto sorted = costs;
        std::sort(sorted.begin(), sorted.end());
        return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    }
};

/// A survey of parallel lanes, 10,000 points two metres apart.
void fly(MapView &map)
{
    engine::Snapshot snapshot = sealedSnapshot(0);
    constexpr double kDegree = 111319.5;
    for (int i = 0; i < kPoints; ++i) {
        const int lane = i / 250, along = lane % 2 ? 249 - i % 250 : i % 250;
        auto &state = snapshot.vehicles.front().state;
        state.position.latitude = 47.3977 + lane * 10 / kDegree;
        state.position.longitude = 8.5456 + along * 2 / kDegree / 0.677;
        snapshot.time = i * 0.4;
        map.showViewState(viewOf(std::make_shared<const engine::Snapshot>(snapshot), 1));
    }
}

/// CPU time of one plain drawing of such a track: a picture filled, and one antialiased line of all points; the median of 15.
double referenceDrawing()
{
    QImage picture(kSize, QImage::Format_ARGB32_Premultiplied);
    Frames frames;
    for (int n = 0; n < 15; ++n) {
        const double before = cpuMilliseconds();
        picture.fill(Qt::white);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        QPolygonF line;
        for (int i = 0; i < kPoints; ++i) {
            const int lane = i / 250, along = lane % 2 ? 249 - i % 250 : i % 250;
            line << QPointF(300 + along * 4.0, 50 + lane * 20.0);
        }
        painter.setPen(QPen(Qt::blue, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
        painter.end();
        frames.costs.push_back(cpuMilliseconds() - before);
    }
    return frames.at(0.5);
}

/// A hundred fields with a thousand points each, 100,000 in all: rows of circles of 40 m with a wave on their edge; or their
/// corners, each a place with a name.
bool writeFields(const QString &path, bool asPoints)
{
    constexpr double kDegree = 111319.5;
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return false;
    file.write("<kml>");
    for (int field = 0; field < 100; ++field) {
        const QByteArray name = "<Placemark><name>Field " + QByteArray::number(field) + "</name>";
        if (!asPoints)
            file.write(name + "<Polygon><outerBoundaryIs><LinearRing><coordinates>");
        for (int i = 0; i < 1000; ++i) {
            const double angle = i * 0.0062832, radius = 18 + 2 * std::sin(40 * angle);
            const double north = (field / 10) * 42 - 190 + radius * std::sin(angle);
            const double east = (field % 10) * 70 - 315 + 1.6 * radius * std::cos(angle);
            const QByteArray place = QByteArray::number(8.5456 + east / kDegree / 0.677, 'f', 8) + ','
                + QByteArray::number(47.3977 + north / kDegree, 'f', 8) + ' ';
            file.write(asPoints ? name + "<Point><coordinates>" + place + "</coordinates></Point></Placemark>" : place);
        }
        if (!asPoints)
            file.write("</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>");
    }
    file.write("</kml>");
    return true;
}

} // namespace

class MapCostTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void panAndZoomOverALongTrack()
    {
        MapView map;
        map.resize(kSize);
        map.show();
        QVERIFY(QTest::qWaitForWindowExposed(&map, test::kDeadlineMs));
        fly(map);
        QCOMPARE(map.content().track().points().size(), std::size_t(kPoints));
        map.repaint();
        QPoint pointer(800, 450);
        Frames pans, zooms;
        QTest::mousePress(&map, Qt::LeftButton, {}, pointer);
        for (int i = 0; i < 120; ++i) {
            pointer += QPoint(i < 60 ? 9 : -9, i % 30 < 15 ? 5 : -5);
            const double before = cpuMilliseconds();
            QTest::mouseMove(&map, pointer);
            map.repaint();
            pans.costs.push_back(cpuMilliseconds() - before);
        }
        QTest::mouseRelease(&map, Qt::LeftButton, {}, pointer);
        for (int i = 0; i < 8; ++i) {
            QTest::keyClick(&map, i < 4 ? Qt::Key_Minus : Qt::Key_Plus);
            double last = 0;
            while (map.viewport().metresPerPixel() != last) {
                last = map.viewport().metresPerPixel();
                const double before = cpuMilliseconds();
                QVERIFY(test::eventually([&] { return map.viewport().metresPerPixel() != last || !map.isMoving(); }));
                map.repaint();
                zooms.costs.push_back(cpuMilliseconds() - before);
            }
        }
        const double reference = referenceDrawing();
        qInfo("pan: median %.1f ms, 99 %% %.1f ms; zoom: median %.1f ms, 99 %% %.1f ms; reference drawing %.1f ms",
              pans.at(0.5), pans.at(0.99), zooms.at(0.5), zooms.at(0.99), reference);
#ifdef NDEBUG
        QVERIFY(pans.at(0.5) < kFrameLimit * reference);
#endif
    }

    void panOverOverlays_data()
    {
        QTest::addColumn<bool>("points");
        QTest::newRow("areas") << false;
        QTest::newRow("points") << true;
    }

    void panOverOverlays()
    {
        QFETCH(bool, points);
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("fields.kml"));
        QVERIFY(writeFields(path, points));
        MapView map;
        map.resize(kSize);
        map.show();
        QVERIFY(QTest::qWaitForWindowExposed(&map, test::kDeadlineMs));
        map.showViewState(viewOf(std::make_shared<const engine::Snapshot>(sealedSnapshot(0)), 1));
        map.overlays().setFiles({OverlayFile{.path = path}});
        EVENTUALLY(map.overlays().entries().front().shapes);
        QCOMPARE(map.overlays().entries().front().shapes->size(), std::size_t(points ? 100'000 : 100));
        const auto costs = [&map](int steps) {
            Frames frames;
            QPoint pointer(800, 450);
            QTest::mousePress(&map, Qt::LeftButton, {}, pointer);
            for (int i = 0; i < steps; ++i) {
                pointer += QPoint(i < steps / 2 ? 3 : -3, i % 30 < 15 ? 2 : -2);
                const double before = cpuMilliseconds();
                QTest::mouseMove(&map, pointer);
                map.repaint();
                frames.costs.push_back(cpuMilliseconds() - before);
            }
            QTest::mouseRelease(&map, Qt::LeftButton, {}, pointer);
            return frames;
        };
        const Frames shown = costs(60);
        map.overlays().setFiles({});
        const Frames none = costs(60);
        const double reference = referenceDrawing();
        qInfo("pan over 100,000 points: median %.1f ms, 99 %% %.1f ms; without them %.1f ms; reference drawing %.1f ms",
              shown.at(0.5), shown.at(0.99), none.at(0.5), reference);
#ifdef NDEBUG
        QVERIFY(shown.at(0.5) - none.at(0.5) < kOverlayLimit * reference);
#endif
    }
};

SKYSEAL_TEST_WIDGETS(MapCostTest)
#include "map_cost_test.moc"
