// Releases the data that OpenSSL keeps for each thread that used it.
#pragma once

namespace skyseal::crypto {

/// Call it last on a thread that used the ciphers. OpenSSL also frees the data after the thread has ended, but a process that
/// waits for a QThread may exit before that.
void endThread();

} // namespace skyseal::crypto
