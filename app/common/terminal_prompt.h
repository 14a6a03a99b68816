// Questions at the controlling terminal, which is there even when standard input and output are files.
#pragma once

#include "core/base/result.h"
#include "core/crypto/passphrase.h"

#include <string>

namespace skyseal::app {

/// A line typed without an echo. Ctrl+C and Ctrl+D cancel. An error names `source`, and without a terminal what does
/// without one: the options of PassphraseInput, whose names begin with `which`.
Result<crypto::Passphrase, InputError> askAtTerminal(const std::string &question, const std::string &source,
                                                     const std::string &which);

} // namespace skyseal::app
