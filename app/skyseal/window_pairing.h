// The engine's pairing behind the windows' interface. A peer that both users confirmed is added to the list of peers.
#pragma once

#include "app/skyseal/station_adapter.h"
#include "core/channel/pairing_passphrase.h"
#include "ui/keys/pairing_interface.h"

#include <QtCore/QThread>

#include <functional>
#include <memory>

namespace skyseal::app {

class WindowPairing : public ui::PairingInterface
{
    Q_OBJECT

public:
    /// See channel::pairingPassphraseKey().
    using DeriveKey = std::function<std::shared_ptr<const Key32>(const crypto::Passphrase &)>;

    explicit WindowPairing(DeriveKey derive = channel::pairingPassphraseKey, QObject *parent = nullptr)
        : PairingInterface(parent), m_derive(std::move(derive))
    {}
    /// Waits for a running key derivation.
    ~WindowPairing() override;

    /// Sets the station, which must outlive it, and its list of peers.
    void use(StationAdapter &station, const std::string &peersFile);

    /// Deriving the key of a passphrase takes a tenth of a second on another thread; the window opens afterwards. Until then no
    /// window is open: an earlier one had another passphrase or none.
    void open(channel::PeerRole roleAsked, const std::optional<crypto::Passphrase> &passphrase) override;
    void confirm(const channel::PublicKey &key, const QString &name, bool replaceKnownKey) override;
    void refuse() override;
    void cancel() override;

private:
    /// True if the station exists; otherwise reports the failure.
    bool isThere();
    /// Null: no memory for the key.
    void openWith(channel::PeerRole roleAsked, std::shared_ptr<const Key32> key);
    void forgetDerivation();
    void handleEvent(const channel::PairingEvent &event);
    void keep(channel::Peer peer);

    DeriveKey m_derive;
    StationAdapter *m_station = nullptr;
    std::string m_peersFile;
    std::string m_name;
    bool m_replace = false;
    std::unique_ptr<QThread> m_deriving;
    quint64 m_derivation = 0; ///< number of the newest one; results of older ones are ignored
    bool m_deaf = false;      ///< no window with the key of the current passphrase is open
};

} // namespace skyseal::app
