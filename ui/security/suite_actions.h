// The choice of the cipher suite, once, as actions: the Security menu and the Secure link panel are two views of it. The
// mark follows what both ends have agreed, never what was asked for: until a switch is confirmed it reads "switching…",
// a roll-back leaves the old suite and one line why. Beside them fresh keys for the suite in use, in the menu alone.
#pragma once

#include "ui/view_state.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QObject>
#include <QtCore/QString>

#include <optional>
#include <vector>

class QAction;
class QActionGroup;

namespace skyseal::ui {

class SuiteActions : public QObject
{
    Q_OBJECT

public:
    explicit SuiteActions(StationInterface &station, QObject *parent = nullptr);

    QAction *action(crypto::SuiteId suite) const;
    const std::vector<QAction *> &actions() const { return m_actions; }

    QAction *changeKeysAction() const { return m_changeKeys; }

    void showViewState(const ViewState &view);
    void handleEvent(const engine::Event &event);
    void setResearchAllowed(bool allowed);
    /// Suites weaker than this one stay grey; see crypto::SuiteStrength.
    void setWeakest(crypto::SuiteId suite);

    /// While a sweep runs, the suite is its business.
    void setHeld(bool held);

    /// Why `suite` cannot be chosen now; empty when it can.
    QString whyNot(crypto::SuiteId suite) const;
    /// The suite that is being agreed.
    std::optional<crypto::SuiteId> pending() const;
    /// What became of the last switch, in one line; empty before the first.
    const QString &note() const { return m_note; }
    bool noteIsProblem() const { return m_noteIsProblem; }

Q_SIGNALS:
    void changed();
    void noteChanged();

private:
    void choose(crypto::SuiteId suite);
    void changeKeys();
    QString whyNoFreshKeys() const;
    void refresh();
    void refreshChangeKeys();
    void setNote(const QString &note, bool problem);

    StationInterface &m_station;
    QActionGroup *m_group;
    std::vector<crypto::SuiteId> m_suites = crypto::sealedSuites();
    std::vector<QAction *> m_actions; ///< of each of `m_suites`
    QAction *m_changeKeys;
    std::optional<channel::SessionInfo> m_info;
    std::optional<crypto::SuiteId> m_asked; ///< chosen here and not yet answered
    bool m_keysAsked = false;               ///< the same for fresh keys
    bool m_researchAllowed = false;
    crypto::SuiteId m_weakest = crypto::SuiteId::Rc4;
    bool m_plain = false;
    bool m_held = false;
    QString m_note;
    bool m_noteIsProblem = false;
};

} // namespace skyseal::ui
