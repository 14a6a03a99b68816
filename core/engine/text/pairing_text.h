// Sentences about a pairing, for the window, the command line and the agent. Translated through QCoreApplication; without a
// translator (command lines) they are English. Each is a whole sentence without its full stop, except reasons.
#pragma once

#include "core/channel/pairing.h"

#include <QtCore/QString>

namespace skyseal::engine {

/// Reason why a pairing failed, to follow "Not paired: "; empty for PairingEnd::Paired.
QString pairingEndText(channel::PairingEnd reason);
QString notPairedText(const QString &reason);
QString pairedText(const QString &peerName);
QString otherDeviceTriedText();
QString passphraseDiffersText();

} // namespace skyseal::engine
