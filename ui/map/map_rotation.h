// Whether the map turns with the vehicle, and the direction that it is to show upwards. Lives on the GUI thread.
#pragma once

#include <QtCore/QObject>

class QAction;

namespace skyseal::ui {

/// The direction follows the vehicle's heading in steps, which are large while the vehicle stands: its compass is never quite
/// still, and a map that trembles cannot be read.
class MapRotation : public QObject
{
    Q_OBJECT

public:
    static constexpr double kStepMoving = 3, kStepStanding = 10; ///< degrees
    static constexpr double kSlowest = 1;                        ///< metres a second; below it, the vehicle stands

    explicit MapRotation(QObject *parent = nullptr);

    bool isOn() const;
    /// Checkable; off at first.
    QAction *action() const { return m_action; }
    /// Takes the vehicle's heading in degrees and its speed over the ground in metres a second; unknown ones are NaN.
    void showHeading(double heading, double groundSpeed);
    /// Direction to show upwards, in degrees; 0 while this is off.
    double target() const { return m_target; }

Q_SIGNALS:
    void toggled(bool on);

private:
    QAction *m_action;
    double m_target = 0;
    bool m_begun = false; ///< the target is a heading of the vehicle
};

} // namespace skyseal::ui
