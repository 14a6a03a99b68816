#include "core/crypto/thread_end.h"

#include <openssl/crypto.h>

namespace skyseal::crypto {

void endThread()
{
    OPENSSL_thread_stop();
}

} // namespace skyseal::crypto
