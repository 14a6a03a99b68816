// The window with its map, above which a copter flies in GUIDED: a second base class for tests of the map's menu.
#pragma once

#include "confirm_question.h"
#include "ui/map/map_view.h"
#include "window_rig.h"

#include <QtGui/QWindow>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMessageBox>

namespace skyseal::ui {

class MapRig : protected WindowRig
{
protected:
    void setUp()
    {
        WindowRig::setUp();
        m_time = 0;
        m_mission.reset();
        m_missionOutdated = {};
        showCopter();
    }

    void open()
    {
        WindowRig::open();
        showCopter();
    }

    void show(const ChangeState &change = {});

    /// Vehicle 2, some 50 m north of vehicle 1.
    void addOther()
    {
        m_station->showTwoSealed(++m_time, {}, [](auto &second) { second.position.latitude += 0.0005; });
    }

    LatLong placeAt(const QPoint &pixel) const { return mercator::unproject(m_map->viewport().toMetres(pixel)); }

    /// Whether a mark of the map is at a place, to a millimetre.
    static bool isAt(const std::optional<QPointF> &mark, const LatLong &place)
    {
        return mark && (*mark - mercator::project(place)).manhattanLength() < 1e-3;
    }

    QMenu *shownMenu() const
    {
        for (QMenu *menu : m_map->findChildren<QMenu *>(QStringLiteral("mapMenu")))
            if (menu->isVisible())
                return menu;
        return nullptr;
    }

    /// By a click as the window system reports it, which QTest's clicks on widgets are not.
    QMenu *openMenu(const QPoint &at)
    {
        QTest::mouseClick(m_window->windowHandle(), Qt::RightButton, {}, m_map->mapTo(m_window.get(), at));
        if (!QTest::qWaitFor([this] { return shownMenu() != nullptr; }, test::kDeadlineMs))
            qFatal("no menu");
        return shownMenu();
    }

    static void choose(QMenu *menu, const char *name)
    {
        auto *entry = menu->findChild<QAction *>(QLatin1String(name));
        if (!entry)
            qFatal("no %s", name);
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
    }

    QMessageBox *question() const { return test::shownQuestion(*m_window); }

    MapView *m_map = nullptr;
    vehicle::MissionItems m_mission;
    Reason m_missionOutdated;
    double m_time = 0;
    const double m_altitude = 12.4;

private:
    void showCopter()
    {
        show();
        m_map = find<MapView>("map");
    }
};

} // namespace skyseal::ui
