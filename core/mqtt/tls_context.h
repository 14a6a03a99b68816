// The TLS settings of a connection to a broker: TLS 1.2 or newer (RFC 5246, 8446), and the broker has to prove its name (RFC
// 6125).
#pragma once

#include "core/base/result.h"
#include "core/mqtt/publisher_config.h"

#include <openssl/ssl.h>

#include <memory>

namespace skyseal::mqtt {

struct FreeTlsContext
{
    void operator()(SSL_CTX *context) const { SSL_CTX_free(context); }
};
using TlsContext = std::unique_ptr<SSL_CTX, FreeTlsContext>;

/// Reads the files. The error names the one that cannot be used, and says why.
Result<TlsContext, InputError> makeTlsContext(const PublisherConfig &config);

} // namespace skyseal::mqtt
