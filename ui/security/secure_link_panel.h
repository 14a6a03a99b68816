// The right dock: how the link is sealed, with whom, since when; the choice of the suite; what was counted. For a plain
// vehicle it says that nothing is sealed and what to do about it.
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
    /// So much height is there: what matters least gives way, first the fingerprint (it stays in the tool tip), then the
    /// kinds of what was refused, then the second line of the note and since when it is sealed.
    void fitHeight(int height) override;

Q_SIGNALS:
    /// The operator picked another session of several: show its vehicle.
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
    int m_room = 0;  ///< 0: as much as it wants
    int m_level = 0; ///< what gave way, see fitHeight()
    bool m_sealed = false;
};

} // namespace skyseal::ui
