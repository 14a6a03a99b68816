// The cipher suites as actions, shown by the Security menu and the Secure link panel. The check mark shows the suite that both
// ends have agreed on, not the requested one: until a switch is confirmed, the requested suite is marked "switching…"; after a
// roll-back, one line gives the reason. A further action changes the keys of the suite in use.
#pragma once

#include "core/channel/session_info.h"
#include "core/engine/common/peer_names.h"
#include "ui/security/remembered_suites.h"
#include "ui/view_state.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QObject>
#include <QtCore/QString>

#include <optional>
#include <vector>

class QAction;
class QActionGroup;
class QSettings;

namespace skyseal::ui {

class SuiteActions : public QObject
{
    Q_OBJECT

public:
    /// The choices are kept in `store`, which must outlive this; without one, they are forgotten with their session.
    explicit SuiteActions(StationInterface &station, QObject *parent = nullptr, QSettings *store = nullptr);

    QAction *action(crypto::SuiteId suite) const;
    const std::vector<QAction *> &actions() const { return m_actions; }

    QAction *changeKeysAction() const { return m_changeKeys; }

    void showViewState(const ViewState &view);
    void handleEvent(const engine::Event &event);
    /// Another station begins, as that of the demo: what the former one said is over.
    void startOver();
    void setResearchAllowed(bool allowed);
    /// Disables suites that are weaker than this one; see crypto::SuiteStrength.
    void setWeakest(crypto::SuiteId suite);

    /// Whether choices are kept, and taken up again in new sessions. At first they are; those of the demo are not.
    void setKeeping(bool on) { m_keeps = on; }
    /// Disables the choice while a sweep controls the suite.
    void setHeld(bool held);

    /// Returns the reason why `suite` cannot be chosen; empty if it can.
    QString disabledReason(crypto::SuiteId suite) const;
    /// The suite of the switch in progress.
    std::optional<crypto::SuiteId> pending() const;
    /// Result of the last switch in one line; empty before the first.
    const QString &note() const { return m_note; }
    bool noteIsProblem() const { return m_noteIsProblem; }

Q_SIGNALS:
    void changed();
    void noteChanged();

private:
    /// Why there is no session whose suite could be switched.
    QString noSession() const;
    void choose(crypto::SuiteId suite);
    void changeKeys();
    QString freshKeysDisabledReason() const;
    void refresh();
    void refreshChangeKeys();
    void takeUpChoices(const ViewState &view);
    void setNote(const QString &note, bool problem, std::optional<channel::SessionId> session = {});

    StationInterface &m_station;
    QActionGroup *m_group;
    std::vector<crypto::SuiteId> m_suites = crypto::sealedSuites();
    std::vector<QAction *> m_actions; ///< of each of `m_suites`
    QAction *m_changeKeys;
    std::optional<channel::SessionInfo> m_info;
    engine::PeerNames m_names;
    std::optional<crypto::SuiteId> m_asked; ///< requested here and not yet answered
    bool m_keysAsked = false;               ///< the same for fresh keys
    bool m_researchAllowed = false;
    crypto::SuiteId m_weakest = crypto::weakestSealedSuite();
    std::optional<RememberedSuites> m_choices;
    std::vector<channel::SessionId> m_fresh; ///< sessions that have come up and were not shown yet
    bool m_keeps = true;
    bool m_plain = false, m_recorded = false;
    bool m_held = false;
    QString m_note;
    bool m_noteIsProblem = false;
    std::optional<channel::SessionId> m_noteSession; ///< that the note is about
};

} // namespace skyseal::ui
