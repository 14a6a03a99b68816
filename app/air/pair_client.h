// skyseal-air --pair: opens the window for pairing of the agent that runs with the same identity, and holds the conversation.
#pragma once

#include "app/common/pairing_prompt.h"

#include <string>

namespace skyseal::app {

/// Runs the event loop until it is over; an exit status. `passphraseKey` is null without a passphrase.
int runPairClient(const QString &program, const std::string &identityFile, PairingPrompt::Settings settings,
                  const Key32 *passphraseKey);

} // namespace skyseal::app
