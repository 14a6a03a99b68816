// What is being recorded and where, and the way to replay what was.
#pragma once

#include "ui/view_state.h"

#include <QtWidgets/QWidget>

class QCheckBox;
class QLabel;
class QPushButton;

namespace skyseal::ui {

class FigureLabel;

class LogsPanel : public QWidget
{
    Q_OBJECT

public:
    /// `folder` is where recordings go.
    LogsPanel(StationInterface &station, const QString &folder, QWidget *parent = nullptr);

    void showViewState(const ViewState &view);

Q_SIGNALS:
    void replayWanted(const QString &file);

private:
    StationInterface &m_station;
    QString m_folder;
    QCheckBox *m_record;
    QLabel *m_file, *m_problem;
    FigureLabel *m_size, *m_frames, *m_dropped;
};

} // namespace skyseal::ui
