// The status bar at the bottom: state of the links with their ports, data rates and recording.
#pragma once

#include "ui/view_state.h"

#include <QtWidgets/QStatusBar>

class QLabel;

namespace skyseal::ui {

class FigureLabel;

class TrafficBar : public QStatusBar
{
    Q_OBJECT

public:
    explicit TrafficBar(QWidget *parent = nullptr);

    void showViewState(const ViewState &view);

private:
    QLabel *m_links;
    FigureLabel *m_rx, *m_tx, *m_recording;
};

} // namespace skyseal::ui
