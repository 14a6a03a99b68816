// The controls of a replay: play and pause, speed, time line, position and length. Space plays and pauses while the focus is in
// the bar. Lives on the GUI thread.
#pragma once

#include "core/engine/replay/replay_command.h"
#include "core/engine/station/replay_status.h"

#include <QtWidgets/QFrame>

class QComboBox;
class QPushButton;

namespace skyseal::ui {

class FigureLabel;
class ReplayTimeline;

class ReplayBar : public QFrame
{
    Q_OBJECT

public:
    explicit ReplayBar(QWidget *parent = nullptr);

    /// Another recording is replayed.
    void startOver();
    void showStatus(const engine::ReplayStatus &status);

Q_SIGNALS:
    void commandRequested(const skyseal::engine::ReplayCommand &command);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void playOrPause();
    void makeActions();
    void stepSpeed(int steps);
    void chooseSpeed(int index);
    void seek(Duration to);
    void showPlaying(bool playing);
    void showPosition();

    QPushButton *m_play;
    QComboBox *m_speed;
    ReplayTimeline *m_line;
    FigureLabel *m_position;
    engine::ReplayStatus m_status;
    std::uint64_t m_requested = 0; ///< seeks; until the replay has got all of them, its position is that of before
};

} // namespace skyseal::ui
