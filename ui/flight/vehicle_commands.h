// Sends commands to the vehicle that the operator looks at and keeps the questions, so that each answer can be told in
// words: "Arm: refused: …". Shared by the buttons and the Vehicle menu.
#pragma once

#include "ui/scene.h"

#include <QtCore/QHash>
#include <QtCore/QObject>
#include <QtCore/QString>

namespace skyseal::ui {

class VehicleCommands : public QObject
{
    Q_OBJECT

public:
    explicit VehicleCommands(StationPort &station, QObject *parent = nullptr);

    void setVehicle(std::uint8_t systemId) { m_systemId = systemId; }
    void send(const vehicle::VehicleCommand &command);
    void take(const engine::Happening &happening);

Q_SIGNALS:
    /// One line for the operator; `ok` is false when the vehicle refused or did not answer.
    void said(const QString &line, bool ok);

private:
    StationPort &m_station;
    std::uint8_t m_systemId = 0;
    QHash<quint32, QString> m_asked;
};

} // namespace skyseal::ui
