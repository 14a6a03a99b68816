// Sends commands to the vehicle that the operator looks at, and to no other than the one that was asked about. Keeps the
// questions, so that each answer can be told in words: "Arm: refused: …". Shared by the buttons and the Vehicle menu.
#pragma once

#include "ui/settings.h"
#include "ui/view_state.h"

#include <QtCore/QHash>
#include <QtCore/QObject>
#include <QtCore/QString>

namespace skyseal::ui {

class VehicleCommands : public QObject
{
    Q_OBJECT

public:
    explicit VehicleCommands(StationInterface &station, QObject *parent = nullptr);

    void showViewState(const ViewState &view);
    /// Empty when a command can go to the vehicle.
    const QString &whyNot() const { return m_whyNot; }
    /// The vehicle that the operator looks at; 0 without one.
    std::uint8_t systemId() const { return m_systemId; }
    /// There are others, so that a question has to say which one it is about.
    bool isOneOfSeveral() const { return m_severalVehicles; }
    /// Says no where there is a reason: one that was asked for before it was there, too. And where another vehicle than
    /// `systemId` is shown now: nobody sees any more what would become of it.
    void send(std::uint8_t systemId, const vehicle::VehicleCommand &command);
    void handleEvent(const engine::Event &event);

    /// How high the next take-off goes, in metres: one number for the panel and the menu.
    double takeOffAltitude() const { return m_takeOffAltitude; }
    void setTakeOffAltitude(double metres);

Q_SIGNALS:
    void takeOffAltitudeChanged(double metres);
    void whyNotChanged(const QString &reason);
    /// One line for the operator; `ok` is false when the vehicle refused or did not answer.
    void resultReported(const QString &line, bool ok);

private:
    StationInterface &m_station;
    std::uint8_t m_systemId = 0;
    bool m_severalVehicles = false;
    QString m_whyNot;
    double m_takeOffAltitude = 10;
    QHash<quint32, QString> m_asked;
};

} // namespace skyseal::ui
