// What OpenSSL keeps for each thread that used it.
#pragma once

namespace skyseal::crypto {

/// To be called last on a thread that used the ciphers. OpenSSL frees its share by itself when the thread has ended, but
/// who waits for a QThread may leave the process before that.
void endThread();

} // namespace skyseal::crypto
