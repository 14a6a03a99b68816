// The mission panel: read the mission, the fence and the rally points from the vehicle, send a mission from a file, save it to
// a file. Says when another station has changed what was read.
#pragma once

#include "core/vehicle/mission_file.h"
#include "ui/mission/mission_model.h"
#include "ui/mission/plan_reader.h"
#include "ui/dock_panel.h"
#include "ui/view_state.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace skyseal::ui {

class ResultLabel;

class MissionPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit MissionPanel(StationInterface &station, QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;
    void applySettings(const Settings &settings) override;
    void handleEvent(const engine::Event &event);
    /// Sends the mission of a file to the vehicle that was selected when the dialog opened; asks first if the vehicle is armed,
    /// or if another station changed its mission.
    /// Shows the reason if the file is invalid, another vehicle is selected or nothing can be sent.
    void sendFile(const QString &file, std::uint8_t systemId);
    void saveFile(const QString &file, const MissionModel::Mission &mission);

private:
    void say(const QString &line);
    static QString kinds(); ///< the name filter of file dialogs
    void read();
    void showName(int vehicle);
    void askAndSend();
    void showOutdated(const engine::VehicleSnapshot *vehicle);
    void askToReplace(const vehicle::MissionFile &plan, std::uint8_t systemId);
    void send(const vehicle::MissionFile &plan, std::uint8_t systemId, bool overwrite);
    bool canSendTo(std::uint8_t systemId);
    void askAndSave();

    StationInterface &m_station;
    PlanReader m_reader;
    MissionModel m_model;
    MissionModel::Mission m_mission;
    QPushButton *m_read, *m_send, *m_save;
    QWidget *m_outdated; ///< shown while something that was read is outdated
    QLabel *m_outdatedText;
    QPushButton *m_readAgain;
    ResultLabel *m_result;
    QStackedWidget *m_pages; ///< the reason why there are no items, or the items
    QLabel *m_empty;
    QString m_disabledReason; ///< reason why nothing can be sent to the vehicle
    std::uint8_t m_systemId = 0;
    bool m_isArmed = false;
    QString m_changed;                ///< how another station changed the mission; empty: not known to be changed
    int m_name = 0;                   ///< of the vehicle, where there are several
    std::uint64_t m_capabilities = 0; ///< of the vehicle
};

} // namespace skyseal::ui
