// One peer: added by its public key, or changed. What is typed is checked at once; a name that is known with another key is
// the changed key of ssh, replaced only knowingly.
#pragma once

#include "ui/keys/keyring_interface.h"

#include <QtWidgets/QDialog>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace skyseal::ui {

class ChangedKeyWarning;

class PeerDialog : public QDialog
{
    Q_OBJECT

public:
    /// Adds a peer.
    explicit PeerDialog(KeyringInterface &keyring, QWidget *parent = nullptr);
    /// Changes one.
    PeerDialog(KeyringInterface &keyring, const KnownPeer &peer, QWidget *parent = nullptr);

    void accept() override;

private:
    PeerDialog(KeyringInterface &keyring, const KnownPeer *peer, QWidget *parent);
    void readKeyFile();
    void check();
    /// A peer whose key is replaced stays what it was, unless the person said otherwise.
    void proposeAsKnown();
    /// What is wrong with what stands there; empty when nothing is. Fills `out` as far as it goes.
    QString problem(KnownPeer &out) const;
    const KnownPeer *knownByName(const QString &name) const;

    KeyringInterface &m_keyring;
    std::vector<KnownPeer> m_peers;
    std::optional<KnownPeer> m_changing;
    bool m_roleChosen = false, m_systemsTyped = false; ///< by the person
    QLineEdit *m_key, *m_name, *m_systems;
    QComboBox *m_role;
    QLabel *m_fingerprint, *m_problem;
    ChangedKeyWarning *m_warning;
    QDialogButtonBox *m_buttons;
};

} // namespace skyseal::ui
