// A pairing without an engine: records the requests of the dialog; a test (or the gallery) emits the events.
#pragma once

#include "ui/keys/pairing_interface.h"

#include <string>
#include <vector>

namespace skyseal::ui {

class FakePairing : public PairingInterface
{
    Q_OBJECT

public:
    struct Confirmation
    {
        channel::PublicKey key{};
        QString name;
        bool replace = false;
    };

    using PairingInterface::PairingInterface;

    void open(const std::optional<crypto::Passphrase> &passphrase) override;
    void confirm(const channel::PublicKey &key, const QString &name, bool replace) override
    {
        confirmations.push_back({key, name, replace});
    }
    void refuse() override { ++refusals; }
    void cancel() override { ++cancels; }

    std::vector<std::string> passphrases; ///< of each opening; empty = none
    std::vector<Confirmation> confirmations;
    int refusals = 0, cancels = 0;
};

} // namespace skyseal::ui
