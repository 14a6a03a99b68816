#include "core/engine/text/pairing_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

namespace {

/// The translations' context of the free functions below.
struct Text
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::engine::PairingText)
};

} // namespace

QString pairingEndText(channel::PairingEnd reason)
{
    using channel::PairingEnd;
    switch (reason) {
    case PairingEnd::Paired: break;
    case PairingEnd::TimedOut: return Text::tr("timed out");
    case PairingEnd::Cancelled: return Text::tr("cancelled");
    case PairingEnd::Armed: return Text::tr("the vehicle was armed");
    case PairingEnd::Refused: return Text::tr("refused here");
    case PairingEnd::RefusedThere: return Text::tr("the other end refused");
    case PairingEnd::Interrupted: return Text::tr("the pairing was interrupted; start again at both ends");
    case PairingEnd::Guessed:
        return Text::tr("three wrong passphrases: they differ, or an attacker is guessing; start again at both ends");
    }
    return {};
}

QString notPairedText(const QString &reason)
{
    return Text::tr("Not paired: %1").arg(reason);
}

QString pairedText(const QString &peerName)
{
    return Text::tr("Paired with %1").arg(peerName);
}

QString otherDeviceTriedText()
{
    return Text::tr("Another device tried to pair at the same time");
}

QString passphraseDiffersText()
{
    return Text::tr(
        "The passphrases of the two ends differ, or only one end has one, or the link is very poor. Start again with the "
        "same passphrase at both ends");
}

} // namespace skyseal::engine
