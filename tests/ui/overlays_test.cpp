// Overlays: added, coloured, hidden, removed and told about through the dialog by real input, drawn by the map, and kept in the
// settings; and their projection across the 180th meridian and around a pole.
#include "tests/support/test_runner.h"
#include "ui/map/clip.h"
#include "ui/map/map_view.h"
#include "ui/overlays/overlay_dialog.h"
#include "window_rig.h"

#include <QtCore/QFile>
#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;
using overlay::ShapeKind;

namespace {

/// An area around the vehicle of the scripted snapshots, 450 m wide.
QByteArray fieldKml()
{
    return "<kml><Placemark><name>Field</name><Polygon><outerBoundaryIs><LinearRing><coordinates>8.543,47.396 8.549,47.396 "
           "8.549,47.400 8.543,47.400 8.543,47.396</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></kml>";
}

/// Whether the filling of an area in `color` is seen near a place of the picture, over the ground of the window.
bool isTinted(const QImage &picture, const QPointF &at, const QColor &color, const QColor &ground)
{
    constexpr double kShare = 0.16;
    const auto isMixed = [](int found, int one, int other) {
        return std::abs(found - (one * kShare + other * (1 - kShare))) < 3;
    };
    for (int i = 0; i < 49; ++i) { // next to lines of the graticule
        const QColor found = picture.pixelColor(at.toPoint() + QPoint(i % 7 - 3, i / 7 - 3));
        if (isMixed(found.red(), color.red(), ground.red()) && isMixed(found.green(), color.green(), ground.green())
            && isMixed(found.blue(), color.blue(), ground.blue()))
            return true;
    }
    return false;
}

ProjectedShape projectedOf(ShapeKind kind, std::vector<overlay::OverlayLine> lines)
{
    overlay::Overlay overlay;
    overlay.shapes.push_back({kind, {}, std::move(lines)});
    return projectOverlay(overlay).front();
}

} // namespace

class OverlaysTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_station->showSealed(1);
    }
    void cleanup() { tearDown(); }

    void filesAreAddedByTheDialogAndStay()
    {
        add(fileOf("field.kml", fieldKml()));
        EVENTUALLY_EQUAL(cell(0, OverlayModel::Shapes), QStringLiteral("1"));
        QCOMPARE(cell(0, OverlayModel::File), QStringLiteral("field.kml"));
        QCOMPARE(cell(0, OverlayModel::Color), QStringLiteral("Blue"));
        QVERIFY(cell(0, OverlayModel::State).isEmpty());
        QVERIFY(isDrawn(OverlayColor::Blue));
        open(); // the choice stays
        m_station->showSealed(2);
        EVENTUALLY(isDrawn(OverlayColor::Blue));
        QCOMPARE(loadOverlays(*m_store).size(), qsizetype(1));
    }

    void tickColourAndRemoveByKeys()
    {
        add(fileOf("field.kml", fieldKml()));
        EVENTUALLY(isDrawn(OverlayColor::Blue));
        view()->setFocus();
        QTest::keyClick(view(), Qt::Key_Space);
        QVERIFY(!isDrawn(OverlayColor::Blue));
        QVERIFY(!loadOverlays(*m_store).front().visible);
        QTest::keyClick(view(), Qt::Key_Space);
        QVERIFY(isDrawn(OverlayColor::Blue));
        QTest::keyClicks(find<QComboBox>("overlayColor"), QStringLiteral("Orange"));
        QVERIFY(isDrawn(OverlayColor::Orange));
        QCOMPARE(loadOverlays(*m_store).front().color, OverlayColor::Orange);
        activate(*find<QDialog>("overlayDialog"));
        view()->setFocus();
        QTest::keyClick(view(), Qt::Key_Delete);
        QVERIFY(!isDrawn(OverlayColor::Orange));
        QVERIFY(loadOverlays(*m_store).isEmpty());
        QVERIFY(find<QLabel>("overlayState")->text().startsWith(QStringLiteral("No overlays.")));
        QVERIFY(!find<QPushButton>("overlayRemove")->isEnabled());
    }

    void spaceTicksWhicheverCellWasClicked()
    {
        add(fileOf("field.kml", fieldKml()));
        EVENTUALLY_EQUAL(cell(0, OverlayModel::Shapes), QStringLiteral("1"));
        const QRect shapes = view()->visualRect(overlays().index(0, OverlayModel::Shapes));
        QTest::mouseClick(view()->viewport(), Qt::LeftButton, {}, shapes.center());
        QTest::keyClick(view(), Qt::Key_Space);
        QVERIFY(!loadOverlays(*m_store).front().visible);
    }

    void errorsStandInTheList()
    {
        add(fileOf("bad.kml", "<kml>\n<Point><coordinates>1,200</coordinates></Point></kml>"));
        const QString problem = QStringLiteral("Not shown: bad.kml:2: the latitude 200 is not within -90 and 90");
        EVENTUALLY_EQUAL(cell(0, OverlayModel::State), problem);
        QCOMPARE(find<QLabel>("overlayState")->text(), problem);
        fileOf("bad.kml", fieldKml());
        QTest::mouseClick(find<QPushButton>("overlayAgain"), Qt::LeftButton);
        EVENTUALLY(isDrawn(OverlayColor::Blue));
        QVERIFY(cell(0, OverlayModel::State).isEmpty());
    }

    void changedAndMissingFilesAreToldInTheList()
    {
        const QString field = fileOf("field.kml", fieldKml()),
                      gone = fileOf("gone.json", R"({"type":"Point","coordinates":[8,47]})");
        add(field);
        add(gone);
        EVENTUALLY_EQUAL(cell(1, OverlayModel::Shapes), QStringLiteral("1"));
        m_window.reset();
        fileOf("field.kml", fieldKml() + "\n");
        QVERIFY(QFile::remove(gone));
        open();
        m_station->showSealed(2);
        openDialog();
        EVENTUALLY_EQUAL(cell(0, OverlayModel::State), QStringLiteral("Changed since it was added"));
        EVENTUALLY(cell(1, OverlayModel::State).startsWith(QStringLiteral("Not shown: gone.json: ")));
        QCOMPARE(m_window->findChildren<QDialog *>().size(), qsizetype(1));
        QVERIFY(isDrawn(OverlayColor::Blue));
        view()->setCurrentIndex(overlays().index(0, 0));
        QTest::mouseClick(find<QPushButton>("overlayAgain"), Qt::LeftButton);
        EVENTUALLY(cell(0, OverlayModel::State).isEmpty());
    }

    /// Without being asked, the shapes that were read stay; the list says that the file has gone.
    void fileThatGoesWhileItIsShownStaysDrawn()
    {
        const QString field = fileOf("field.kml", fieldKml());
        add(field);
        EVENTUALLY(isDrawn(OverlayColor::Blue));
        QTest::keyClick(find<QDialog>("overlayDialog"), Qt::Key_Escape);
        EVENTUALLY(!m_window->findChild<QDialog *>(QStringLiteral("overlayDialog")));
        QVERIFY(QFile::remove(field));
        openDialog();
        EVENTUALLY(cell(0, OverlayModel::State).startsWith(QStringLiteral("Shown as last read: field.kml: ")));
        QVERIFY(isDrawn(OverlayColor::Blue));
    }

    void filesAreBounded()
    {
        const QString first = fileOf("0.json", R"({"type":"Point","coordinates":[8,47]})");
        for (int i = 1; i < kMostOverlays; ++i)
            QVERIFY(overlays().add(fileOf(qPrintable(QString::number(i) + QStringLiteral(".json")), "{}")));
        QVERIFY(overlays().add(first));
        add(fileOf("more.json", "{}"));
        QCOMPARE(overlays().rowCount(), kMostOverlays);
        QVERIFY(find<QLabel>("overlayState")->text().contains(QStringLiteral("no more can be added")));
        QVERIFY(overlays().add(first)); // is read again
    }

    void linesTakeTheShortWayAcrossTheMeridian()
    {
        const ProjectedShape line = projectedOf(ShapeKind::Line, {{{0, 170}, {1, -170}, {2, 175}}});
        const double degree = mercator::kMetresPerDegree;
        QCOMPARE(line.lines[0][1].x(), 190 * degree);
        QCOMPARE(line.lines[0][2].x(), 175 * degree);
        QCOMPARE(line.box.width(), 20 * degree);
    }

    void holesStandInTheirRing()
    {
        const ProjectedShape area = projectedOf(
            ShapeKind::Polygon, {{{0, 170}, {0, -170}, {9, -170}, {9, 170}}, {{1, -175}, {1, -174}, {2, -174}}});
        QVERIFY(area.box.contains(area.lines[1].boundingRect()));
        QVERIFY(area.lines[0].containsPoint(area.caption, Qt::OddEvenFill));
    }

    void ringsAroundAPoleReachTheEdgeOfTheMap()
    {
        const ProjectedShape cap = projectedOf(ShapeKind::Polygon, {{{70, 0}, {70, 120}, {70, -120}}});
        QCOMPARE(cap.box.bottom(), mercator::kHalfWorld);
        QCOMPARE(cap.box.width(), 2 * mercator::kHalfWorld);
        const ProjectedShape south = projectedOf(ShapeKind::Polygon, {{{-70, 0}, {-90, 120}, {-70, -120}}});
        QCOMPARE(south.box.top(), -mercator::kHalfWorld);
    }

    /// Shapes beyond the meridian are seen from both sides of it.
    void mapShowsThemOnBothSidesOfTheMeridian()
    {
        add(fileOf("far.json", R"({"type":"Polygon","coordinates":[[[178,-1],[-178,-1],[-178,1],[178,1]]]})"));
        EVENTUALLY_EQUAL(cell(0, OverlayModel::Shapes), QStringLiteral("1"));
        for (const double longitude : {-179.5, 179.5, 180.5}) {
            MapView map;
            map.resize(400, 300);
            map.showViewState(sealedView(1, [longitude](auto &state) {
                state.position.latitude = 0.5;
                state.position.longitude = longitude;
            }));
            map.overlays().setFiles(overlays().files());
            const auto drawn = [&map] {
                return isTinted(map.grab().toImage(), {40, 220}, overlayColor(OverlayColor::Blue, map.palette()),
                                map.palette().color(QPalette::Base));
            };
            EVENTUALLY(drawn());
        }
    }

    void clippedShapesAreTheSameWithinTheArea()
    {
        const QRectF area(0, 0, 100, 100);
        const QPolygonF ring{QPointF(-1e9, 50), QPointF(50, -1e9), QPointF(1e9, 50), QPointF(50, 1e9)};
        QCOMPARE(clipRing(ring, area).boundingRect(), area);
        QVERIFY(clipRing(QPolygonF{QPointF(-5, -5), QPointF(-1, -5), QPointF(-1, -1)}, area).isEmpty());
        // In, out, past the corner, and in again.
        const auto pieces = clipLine(
            QPolygonF{QPointF(10, 10), QPointF(20, 10), QPointF(20, -10), QPointF(-9, -10), QPointF(-9, 40), QPointF(50, 40)},
            area);
        QCOMPARE(pieces.size(), std::size_t(2));
        QCOMPARE(pieces[0], (QPolygonF{QPointF(10, 10), QPointF(20, 10), QPointF(20, 0)}));
        QCOMPARE(pieces[1], (QPolygonF{QPointF(0, 40), QPointF(50, 40)}));
    }

private:
    OverlayModel &overlays() const { return find<MapView>("map")->overlays(); }
    QTreeView *view() const { return find<QTreeView>("overlayView"); }
    QString cell(int row, OverlayModel::Column column) const { return overlays().index(row, column).data().toString(); }

    QString fileOf(const char *name, const QByteArray &content)
    {
        QFile file(m_folder->filePath(QLatin1String(name)));
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        return file.fileName();
    }

    /// Shortcuts work in the active window.
    static void activate(QWidget &window)
    {
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window, test::kDeadlineMs));
    }

    void openDialog()
    {
        activate(*m_window);
        QTest::keyClick(m_window.get(), Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        EVENTUALLY(m_window->findChild<QDialog *>(QStringLiteral("overlayDialog")));
    }

    void add(const QString &path)
    {
        openDialog();
        QTest::mouseClick(find<QPushButton>("overlayAdd"), Qt::LeftButton);
        auto *files = find<QDialog>("overlayDialog")->findChild<QFileDialog *>();
        QVERIFY(files);
        auto *name = files->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
        name->clear();
        name->insert(path); // as a paste: typing opens a list of files, which would take the key
        QTest::keyClick(name, Qt::Key_Return);
        EVENTUALLY(!find<QDialog>("overlayDialog")->findChild<QFileDialog *>());
    }

    /// The field lies around the vehicle, in the middle of the map.
    bool isDrawn(OverlayColor color) const
    {
        auto *map = find<MapView>("map");
        const QPointF at = map->viewport().toPixels(mercator::project({47.3975, 8.5453}));
        return isTinted(map->grab().toImage(), at, overlayColor(color, map->palette()), map->palette().color(QPalette::Base));
    }
};

SKYSEAL_TEST_WIDGETS(OverlaysTest)
#include "overlays_test.moc"
