// Measuring on the map: places that the operator sets one after another, and the ways between them. While it is on, the map
// gives it clicks and keys, and neither selects vehicles nor opens its menu. Lives on the GUI thread.
#pragma once

#include "ui/map/geodesic.h"
#include "ui/text/units.h"

#include <QtCore/QObject>

#include <optional>
#include <vector>

class QAction;
class QKeyEvent;

namespace skyseal::ui {

class MeasureTool : public QObject
{
    Q_OBJECT

public:
    explicit MeasureTool(QObject *parent = nullptr);

    /// Checkable: begins and ends the measurement. For a menu of the window.
    QAction *action() const { return m_action; }
    bool isOn() const;
    void end();

    void add(const LatLong &place);
    void removeLast();
    /// A key of the map: Return, Enter and Space set a point at `pointed`, Backspace removes the last one, Escape ends. Returns
    /// false for other keys, and for all while it is off.
    bool handleKey(const QKeyEvent &event, const std::optional<LatLong> &pointed);

    const std::vector<LatLong> &points() const { return m_points; }
    /// One less than points.
    const std::vector<Geodesic> &legs() const { return m_legs; }
    double totalMetres() const;

Q_SIGNALS:
    void changed();

private:
    QAction *m_action;
    std::vector<LatLong> m_points;
    std::vector<Geodesic> m_legs;
};

/// "412 m · 087°": length and bearing.
QString legText(const Geodesic &leg, UnitSystem units);
/// One sentence of what was measured: "1203 m in 3 legs".
QString measuredText(const MeasureTool &tool, UnitSystem units);

} // namespace skyseal::ui
