// The dialog that asks for the passphrase of a sealed key, as the reader of key files wants it.
#pragma once

#include "core/keys/secret_file.h"

namespace skyseal::app {

/// Asks until the file opens or the operator gives up. GUI thread; waits for the answer.
Result<crypto::Passphrase, InputError> askInDialog(const std::string &file, int attempt);

} // namespace skyseal::app
