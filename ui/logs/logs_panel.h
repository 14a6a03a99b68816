// The state of the recording, and a button to replay a log.
#pragma once

#include "ui/dock_panel.h"
#include "ui/view_state.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace skyseal::ui {

class FigureLabel;

class LogsPanel : public DockPanel
{
    Q_OBJECT

public:
    /// `folder` is the folder of the recordings.
    LogsPanel(StationInterface &station, const QString &folder, QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;

Q_SIGNALS:
    void replayRequested();

private:
    StationInterface &m_station;
    QString m_folder;
    QCheckBox *m_record;
    QLabel *m_file, *m_problem;
    FigureLabel *m_size, *m_frames, *m_dropped;
};

} // namespace skyseal::ui
