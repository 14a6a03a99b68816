// Prompts at the controlling terminal, which exists even if standard input and output are redirected.
#pragma once

#include "core/base/result.h"

#include <string>

namespace skyseal::crypto {
class Passphrase;
}

namespace skyseal::app {

/// A line entered without echo. Ctrl+C and Ctrl+D cancel. Errors name `source`; without a terminal the error names the
/// alternatives, the options of PassphraseInput with the prefix `which`.
Result<crypto::Passphrase, InputError> askAtTerminal(const std::string &question, const std::string &source,
                                                     const std::string &which);

} // namespace skyseal::app
