// A keyring without files: records the changes of the dialogs and holds the content that a test (or the gallery) sets.
#pragma once

#include "ui/keys/keyring_interface.h"

#include <algorithm>
#include <string>
#include <utility>

namespace skyseal::ui {

class FakeKeyring : public KeyringInterface
{
    Q_OBJECT

public:
    using KeyringInterface::KeyringInterface;

    OwnKey ownKey() const override { return own; }
    PeerList peerList() const override { return list; }
    Result<void, InputError> addPeer(const KnownPeer &peer) override
    {
        return commit([&] { list.peers.push_back(peer); });
    }
    Result<void, InputError> changePeer(const QString &name, const KnownPeer &changed) override
    {
        return commit([&] {
            for (KnownPeer &peer : list.peers)
                if (peer.name == name)
                    peer = changed;
        });
    }
    Result<void, InputError> removePeer(const QString &name) override
    {
        return commit([&] { std::erase_if(list.peers, [&](const KnownPeer &peer) { return peer.name == name; }); });
    }
    Result<QString, InputError> readKeyText(const QString &) const override { return fileText; }
    Result<void, InputError> exportPublicKey(const QString &) const override { return {}; }

    void changePassphrase(std::optional<crypto::Passphrase> present, std::optional<crypto::Passphrase> next,
                          bool remember) override;
    /// The end of the work that changePassphrase() began.
    void finishPassphrase(const QString &problem)
    {
        if (problem.isEmpty())
            own.sealed = !passphrases.back().second.empty();
        Q_EMIT changed();
        Q_EMIT passphraseDone(problem);
    }

    void notify() { Q_EMIT changed(); }

    OwnKey own;
    PeerList list;
    QString fileText;
    std::vector<std::pair<std::string, std::string>> passphrases; ///< the present one and the next; empty = none
    bool remembers = false;                                       ///< as the last change wanted it
    QString refusal;                                              ///< error of every change; empty: changes succeed

private:
    template<typename Act> Result<void, InputError> commit(Act act)
    {
        if (!refusal.isEmpty())
            return tl::unexpected(InputError{refusal.toStdString(), {}});
        act();
        Q_EMIT changed();
        return {};
    }
};

} // namespace skyseal::ui
