// skyseal-air --pair: opens the pairing window of the running agent with the same identity, and prompts the user.
#pragma once

#include "app/common/pairing_prompt.h"

#include <string>

namespace skyseal::app {

/// Runs the event loop until the pairing ends; returns an exit status. `passphrase` is null without one.
int runPairClient(const QString &program, const std::string &identityFile, PairingPrompt::Settings settings,
                  const crypto::Passphrase *passphrase);

} // namespace skyseal::app
