// The bar across the top of the window that says when the picture is not the live one: a replay, or the demo. During a replay
// it shows the state of the live link as well. Lives on the GUI thread.
#pragma once

#include "ui/view_state.h"

#include <QtWidgets/QFrame>

class QLabel;
class QPushButton;

namespace skyseal::ui {

class ReplayBar;

class SourceBar : public QFrame
{
    Q_OBJECT

public:
    enum class Source { Live, Replay, Demo };

    /// Also makes the bar of the controls of a replay, as another child of `parent`.
    explicit SourceBar(QWidget *parent = nullptr);

    /// Visible during a replay; it stands below this bar.
    ReplayBar *replayBar() const { return m_replay; }
    Source source() const { return m_source; }
    void showSource(Source source, const QString &name = {});
    /// The live link, during a replay.
    void showLive(const ViewState &live);
    /// The recording that is replayed.
    void showReplay(const ViewState &replay);

Q_SIGNALS:
    /// Back to live, or end the demo.
    void endRequested();

protected:
    void changeEvent(QEvent *event) override;

private:
    void paintSource();
    void setState(const QString &text, bool alarm);

    Source m_source = Source::Live;
    QString m_name;
    QLabel *m_title, *m_state;
    QPushButton *m_end;
    ReplayBar *m_replay;
    bool m_alarm = false;
};

} // namespace skyseal::ui
