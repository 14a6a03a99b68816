// What is being recorded and where, and the way to replay what was.
#pragma once

#include "ui/scene.h"

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
    LogsPanel(StationPort &station, const QString &folder, QWidget *parent = nullptr);

    void showScene(const Scene &scene);

Q_SIGNALS:
    void replayWanted(const QString &file);

private:
    StationPort &m_station;
    QString m_folder;
    QCheckBox *m_record;
    QLabel *m_file, *m_problem;
    FigureLabel *m_size, *m_frames, *m_dropped;
};

} // namespace skyseal::ui
