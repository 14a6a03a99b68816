// The secure link panel: peer, suite and age of the session, the choice of the suite, and the counters. For a plain vehicle it
// shows that nothing is sealed and how to seal the link.
#pragma once

#include "ui/dock_panel.h"
#include "ui/view_state.h"

class QComboBox;
class QFrame;
class QLabel;
class QPushButton;

namespace skyseal::ui {

class CountersTable;
class SuiteActions;

class SecureLinkPanel : public DockPanel
{
    Q_OBJECT

public:
    explicit SecureLinkPanel(SuiteActions &suites, QWidget *parent = nullptr);

    void showViewState(const ViewState &view) override;
    /// Hides parts until the panel fits into `height` pixels: first the fingerprint (it stays in the tool tip), then the kinds
    /// of refused records, then the second line of the note and the age of the session.
    void fitHeight(int height) override;
    bool scrollsAsAWhole() const override { return true; }

Q_SIGNALS:
    /// The operator selected another session; its vehicle is to be shown.
    void sessionChosen(quint32 session);
    void helpRequested(const QString &page);
    void keysRequested();

private:
    void showHead(const ViewState &view);
    void showSessions(const ViewState &view);
    void showNote();
    void arrange();
    void applyFit(int level);

    SuiteActions &m_suites;
    QLabel *m_icon, *m_title, *m_peer, *m_since, *m_fingerprint, *m_note, *m_advice;
    QPushButton *m_help, *m_keys;
    QComboBox *m_sessions;
    CountersTable *m_counters;
    QFrame *m_line;
    int m_room = 0;  ///< pixels; 0: unlimited
    int m_level = 0; ///< number of hidden parts, see fitHeight()
    bool m_sealed = false;
};

} // namespace skyseal::ui
