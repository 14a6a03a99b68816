// Shown over the map while there is no vehicle: the state of the link, and the next step for the operator. Touch-sized, it
// scrolls where the map is smaller.
#pragma once

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/view_state.h"

#include <QtWidgets/QScrollArea>

class QLabel;
class QPushButton;

namespace skyseal::ui {

class EmptyState : public QScrollArea
{
    Q_OBJECT

public:
    explicit EmptyState(QWidget *parent = nullptr);

    /// Hides itself once there is a vehicle.
    void showViewState(const ViewState &view);
    void setDemoAvailable(bool available);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void demoRequested();
    void connectRequested();
    void keysRequested();
    /// The operator wants to allow plain MAVLink for this vehicle.
    void plainRequested(const skyseal::engine::PendingVehicle &held);

private:
    QLabel *m_title, *m_text, *m_command, *m_otherwise;
    QPushButton *m_demo, *m_connect, *m_plain, *m_keys;
    engine::PendingVehicle m_held;
};

} // namespace skyseal::ui
