// The engine's pairing behind the windows' interface. A peer that both users confirmed is added to the list of peers.
#pragma once

#include "app/skyseal/station_adapter.h"
#include "ui/keys/pairing_interface.h"

#include <string>

namespace skyseal::app {

class WindowPairing : public ui::PairingInterface
{
    Q_OBJECT

public:
    using PairingInterface::PairingInterface;

    /// Sets the station, which must outlive it, and its list of peers.
    void use(StationAdapter &station, const std::string &peersFile);

    void open(const std::optional<crypto::Passphrase> &passphrase) override;
    void confirm(const channel::PublicKey &key, const QString &name, bool replaceKnownKey) override;
    void refuse() override;
    void cancel() override;

private:
    /// True if the station exists; otherwise reports the failure.
    bool isThere();
    void handleEvent(const channel::PairingEvent &event);
    void keep(channel::Peer peer);

    StationAdapter *m_station = nullptr;
    std::string m_peersFile;
    std::string m_name;
    bool m_replace = false;
};

} // namespace skyseal::app
