#include "core/engine/text/pairing_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

namespace {

/// The translations' context of the free functions below.
struct PairingText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::engine::PairingText)
};

} // namespace

QString pairingEndText(channel::PairingEnd reason)
{
    using channel::PairingEnd;
    switch (reason) {
    case PairingEnd::Paired: break;
    case PairingEnd::TimedOut: return PairingText::tr("timed out");
    case PairingEnd::Cancelled: return PairingText::tr("cancelled");
    case PairingEnd::Armed: return PairingText::tr("the vehicle was armed");
    case PairingEnd::Refused: return PairingText::tr("refused here");
    case PairingEnd::RefusedThere: return PairingText::tr("the other end refused");
    case PairingEnd::Interrupted: return PairingText::tr("the pairing was interrupted; start again at both ends");
    case PairingEnd::Guessed:
        return PairingText::tr("three wrong passphrases: they differ, or an attacker is guessing; start again at both ends");
    }
    return {};
}

QString notPairedText(const QString &reason)
{
    return PairingText::tr("Not paired: %1").arg(reason);
}

QString pairedText(const QString &peerName)
{
    return PairingText::tr("Paired with %1").arg(peerName);
}

QString otherDeviceTriedText()
{
    return PairingText::tr("Another device tried to pair at the same time");
}

QString passphraseDiffersText()
{
    return PairingText::tr(
        "The passphrases of the two ends differ, or only one end has one, or the link is very poor. Start again with the "
        "same passphrase at both ends");
}

} // namespace skyseal::engine
