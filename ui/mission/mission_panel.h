// The mission: read it from the vehicle, send one from a file, keep it in a file.
#pragma once

#include "ui/mission/mission_model.h"
#include "ui/dock_panel.h"
#include "ui/view_state.h"

class QLabel;
class QPushButton;

namespace skyseal::ui {

class MissionPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit MissionPanel(StationInterface &station, QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;
    void handleEvent(const engine::Event &event);
    /// Sends the mission of a file to the vehicle that it was chosen for; says so when it is none, or when that vehicle is
    /// not shown any more or cannot be sent anything.
    void sendFile(const QString &file, std::uint8_t systemId);
    void saveFile(const QString &file, const MissionModel::Mission &mission);

private:
    void say(const QString &line);
    static QString kinds(); ///< of files, for the dialogs that ask for one
    void askAndSend();
    void askAndSave();

    StationInterface &m_station;
    MissionModel m_model;
    MissionModel::Mission m_mission;
    QPushButton *m_read, *m_send, *m_save;
    QLabel *m_result;
    QString m_whyNot; ///< why nothing can be sent to the vehicle
    std::uint8_t m_systemId = 0;
};

} // namespace skyseal::ui
