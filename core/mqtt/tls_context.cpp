#include "core/mqtt/tls_context.h"

#include "core/base/secret_bytes.h"
#include "core/keys/file_io.h"

#include <arpa/inet.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

namespace skyseal::mqtt {

namespace {

tl::unexpected<InputError> wrong(const std::string &file, const char *problem)
{
    ERR_clear_error();
    return tl::unexpected(InputError{problem, file});
}

/// Instead of a question at the terminal.
int noPassphrase(char *, int, int, void *)
{
    return -1;
}

/// The private key of a PEM file that nobody else can read.
Result<void, InputError> useKey(SSL_CTX *context, const std::string &file)
{
    auto content = keys::readFile(file, keys::FileAccess::Private);
    if (!content)
        return tl::unexpected(content.error());
    BIO *pem = BIO_new_mem_buf(content->data(), static_cast<int>(content->size()));
    EVP_PKEY *key = PEM_read_bio_PrivateKey(pem, nullptr, noPassphrase, nullptr);
    BIO_free(pem);
    wipeSecret(*content);
    const bool used = key && SSL_CTX_use_PrivateKey(context, key) == 1;
    EVP_PKEY_free(key);
    if (!key)
        return wrong(file, "holds no private key in PEM that can be read without a passphrase");
    if (!used || SSL_CTX_check_private_key(context) != 1)
        return wrong(file, "this private key does not belong to the certificate of --mqtt-cert");
    return {};
}

/// An address is compared with the addresses in the certificate, any other host with its names.
bool expectHost(SSL_CTX *context, const std::string &host)
{
    X509_VERIFY_PARAM *expected = SSL_CTX_get0_param(context);
    unsigned char address[sizeof(in6_addr)];
    if (::inet_pton(AF_INET, host.c_str(), address) == 1 || ::inet_pton(AF_INET6, host.c_str(), address) == 1)
        return X509_VERIFY_PARAM_set1_ip_asc(expected, host.c_str()) == 1;
    X509_VERIFY_PARAM_set_hostflags(expected, X509_CHECK_FLAG_NO_PARTIAL_WILDCARDS);
    return X509_VERIFY_PARAM_set1_host(expected, host.c_str(), host.size()) == 1;
}

} // namespace

Result<TlsContext, InputError> makeTlsContext(const PublisherConfig &config)
{
    TlsContext context(SSL_CTX_new(TLS_client_method()));
    if (!context || SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION) != 1
        || !expectHost(context.get(), config.broker.host))
        return wrong(config.broker.toText(), "TLS cannot be set up");
    SSL_CTX_set_verify(context.get(), SSL_VERIFY_PEER, nullptr);
    SSL_CTX_set_options(context.get(), SSL_OP_NO_COMPRESSION | SSL_OP_NO_RENEGOTIATION);
    if (config.caFile.empty())
        SSL_CTX_set_default_verify_paths(context.get());
    else if (SSL_CTX_load_verify_locations(context.get(), config.caFile.c_str(), nullptr) != 1)
        return wrong(config.caFile, "cannot be read, or holds no certificate in PEM");
    if (config.certificateFile.empty())
        return context;
    if (SSL_CTX_use_certificate_chain_file(context.get(), config.certificateFile.c_str()) != 1)
        return wrong(config.certificateFile, "cannot be read, or holds no certificate in PEM");
    if (auto used = useKey(context.get(), config.keyFile); !used)
        return tl::unexpected(used.error());
    return context;
}

} // namespace skyseal::mqtt
