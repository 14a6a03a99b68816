// Chooses a recording to replay: those of the folder of the recordings with date, vehicle and length, or any other file.
#pragma once

#include "ui/replay/recording_model.h"
#include "ui/station_interface.h"

#include <QtWidgets/QDialog>

class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace skyseal::ui {

class RecordingsDialog : public QDialog
{
    Q_OBJECT

public:
    /// Lists the recordings of `folder` at once; `station` must outlive the dialog.
    RecordingsDialog(StationInterface &station, const QString &folder, QWidget *parent = nullptr);
    ~RecordingsDialog() override;

Q_SIGNALS:
    void fileChosen(const QString &file);

private:
    void showState();
    void replaySelected();
    void chooseOther();
    void choose(const QString &file);

    StationInterface &m_station;
    const QString m_folder;
    bool m_listed = false;
    RecordingModel m_model;
    QSortFilterProxyModel *m_sorted;
    QTreeView *m_view;
    QLabel *m_state;
    QPushButton *m_replay;
};

} // namespace skyseal::ui
