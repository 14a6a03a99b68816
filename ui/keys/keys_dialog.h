// The dialog of this station's key and its known peers, with the functions of skyseal-cli keys.
#pragma once

#include "ui/keys/keyring_interface.h"
#include "ui/keys/peer_model.h"

#include <QtWidgets/QDialog>

#include <functional>
#include <utility>

class QLabel;
class QPushButton;
class QStackedWidget;
class QTreeView;

namespace skyseal::ui {

class OwnKeyBox;

class KeysDialog : public QDialog
{
    Q_OBJECT

public:
    explicit KeysDialog(KeyringInterface &keyring, QWidget *parent = nullptr);

    /// Shows the button for pairing.
    void offerPairing();
    /// `armedOf` returns the system IDs of the armed vehicles at the peer with this name, as "1, 2"; empty if none is.
    void setArmed(std::function<QString(const QString &name)> armedOf) { m_armedOf = std::move(armedOf); }

Q_SIGNALS:
    void pairRequested();

private:
    void refresh();
    void addPeer();
    void changePeer();
    void revokePeer();
    void notify(const QString &problem);
    const KnownPeer *chosen() const;

    KeyringInterface &m_keyring;
    OwnKeyBox *m_own;
    PeerModel m_model;
    QTreeView *m_view;
    QStackedWidget *m_pages;
    QLabel *m_empty, *m_file, *m_problem;
    QPushButton *m_add, *m_pair, *m_change, *m_revoke;
    std::function<QString(const QString &)> m_armedOf;
};

} // namespace skyseal::ui
