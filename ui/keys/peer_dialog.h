// The dialog that adds a peer by its public key or changes one. Input is checked at once. A known name with another key is
// treated like a changed host key of ssh: it is replaced only after confirmation.
#pragma once

#include "ui/keys/keyring_interface.h"

#include <QtWidgets/QDialog>

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
    /// Replacing the key of a peer keeps its systems, unless they were edited.
    void proposeAsKnown();
    /// Returns the first error of the input; empty if it is valid. Fills `out` as far as possible.
    QString problem(KnownPeer &out) const;
    const KnownPeer *knownByName(const QString &name) const;

    KeyringInterface &m_keyring;
    std::vector<KnownPeer> m_peers;
    std::optional<KnownPeer> m_changing;
    bool m_systemsTyped = false; ///< edited by the operator
    QLineEdit *m_key, *m_name, *m_systems;
    QLabel *m_fingerprint, *m_problem;
    ChangedKeyWarning *m_warning;
    QDialogButtonBox *m_buttons;
};

} // namespace skyseal::ui
