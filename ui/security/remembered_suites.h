// The suite that the operator chose last for each peer, kept in the settings as "suites/KEY", so that its next session can go
// on with it. Lives on the GUI thread.
#pragma once

#include "core/crypto/public_key.h"
#include "core/crypto/suite.h"

#include <optional>

class QSettings;

namespace skyseal::ui {

class RememberedSuites
{
public:
    static constexpr int kMostPeers = 256;

    /// `store` must outlive this.
    explicit RememberedSuites(QSettings &store) : m_store(store) {}

    /// Research suites are not kept: each of their sessions takes a decision of its own.
    void remember(const crypto::PublicKey &peer, crypto::SuiteId suite);
    /// nullopt if none was chosen, or what is stored is no suite to be kept.
    std::optional<crypto::SuiteId> of(const crypto::PublicKey &peer) const;

private:
    QSettings &m_store;
};

} // namespace skyseal::ui
