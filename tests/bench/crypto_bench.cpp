// What sealing and opening a record cost over the bare library calls that they cannot do without, per suite and size, in
// one run. "bare" is: AEAD, the library's one-shot call (libsodium) or nonce, associated data, text and tag (OpenSSL);
// others, the cipher's own call and the HMAC over the record's bytes, from copied hash states.
#define OPENSSL_SUPPRESS_DEPRECATED
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"

#include <benchmark/benchmark.h>
#include <openssl/evp.h>
#include <openssl/provider.h>
#include <openssl/sha.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

using namespace skyseal;
using namespace skyseal::crypto;

namespace {

constexpr std::size_t kAssociatedSize = 10; // first byte, connection id, counter, suite, direction, link
constexpr std::array<std::size_t, 4> kSizes{9, 28, 64, 255};

/// The bytes and keys that a bare call works on; their values do not matter for its time.
struct Material
{
    std::array<std::uint8_t, 32> key{};
    std::array<std::uint8_t, 16> nonce{};
    std::array<std::uint8_t, kAssociatedSize> associated{};
    std::array<std::uint8_t, 512> text{};
    std::array<std::uint8_t, 32> tag{};
    SHA256_CTX inner{};
    SHA256_CTX outer{};

    Material()
    {
        std::array<std::uint8_t, 64> pad{};
        SHA256_Init(&inner);
        SHA256_Update(&inner, pad.data(), pad.size());
        outer = inner;
    }

    void hmac(std::size_t size)
    {
        SHA256_CTX state = inner;
        SHA256_Update(&state, associated.data(), associated.size());
        SHA256_Update(&state, text.data(), size);
        SHA256_Final(tag.data(), &state);
        state = outer;
        SHA256_Update(&state, tag.data(), tag.size());
        SHA256_Final(tag.data(), &state);
    }
};

/// One bare call of so many bytes.
using BareCall = std::function<void(std::size_t size)>;

enum class CipherUse { Encrypt, Decrypt };

EVP_CIPHER_CTX *keyed(EVP_CIPHER *cipher, const Material &m, bool rc4 = false, CipherUse use = CipherUse::Encrypt)
{
    const int encrypt = use == CipherUse::Encrypt ? 1 : 0;
    EVP_CIPHER_CTX *context = EVP_CIPHER_CTX_new();
    EVP_CipherInit_ex2(context, cipher, nullptr, nullptr, encrypt, nullptr);
    if (rc4)
        EVP_CIPHER_CTX_set_key_length(context, 32);
    EVP_CipherInit_ex2(context, nullptr, m.key.data(), m.nonce.data(), encrypt, nullptr);
    EVP_CIPHER_CTX_set_padding(context, 0);
    return context;
}

BareCall bareCipher(SuiteId suite, Material &m, CipherUse use = CipherUse::Encrypt)
{
    int written = 0;
    if (suite == SuiteId::ChaCha20) {
        return [&m](std::size_t n) {
            crypto_stream_chacha20_ietf_xor(m.text.data(), m.text.data(), n, m.nonce.data(), m.key.data());
        };
    }
    if (suite == SuiteId::Aes256Ctr || suite == SuiteId::Aes256Cbc) {
        EVP_CIPHER_CTX *context =
            keyed(EVP_CIPHER_fetch(nullptr, suite == SuiteId::Aes256Ctr ? "AES-256-CTR" : "AES-256-CBC", nullptr), m, false, use);
        const bool blocks = suite == SuiteId::Aes256Cbc;
        return [&m, context, blocks, written](std::size_t n) mutable {
            EVP_CipherInit_ex2(context, nullptr, nullptr, m.nonce.data(), -1, nullptr);
            const std::size_t size = blocks ? (n / 16 + 1) * 16 : n;
            EVP_CipherUpdate(context, m.text.data(), &written, m.text.data(), static_cast<int>(size));
        };
    }
    OSSL_LIB_CTX *library = OSSL_LIB_CTX_new();
    OSSL_PROVIDER_load(library, "legacy");
    EVP_CIPHER_CTX *context = keyed(EVP_CIPHER_fetch(library, "RC4", nullptr), m, true);
    return [&m, context, written](std::size_t n) mutable {
        std::array<std::uint8_t, 768> dropped;
        EVP_EncryptInit_ex2(context, nullptr, m.key.data(), nullptr, nullptr);
        EVP_EncryptUpdate(context, dropped.data(), &written, dropped.data(), static_cast<int>(dropped.size()));
        EVP_EncryptUpdate(context, m.text.data(), &written, m.text.data(), static_cast<int>(n));
    };
}

BareCall bareSeal(SuiteId suite, Material &m)
{
    int written = 0;
    if (suite == SuiteId::ChaCha20Poly1305) {
        return [&m](std::size_t n) {
            crypto_aead_chacha20poly1305_ietf_encrypt(m.text.data(), nullptr, m.text.data(), n, m.associated.data(),
                                                      m.associated.size(), nullptr, m.nonce.data(), m.key.data());
        };
    }
    if (suite == SuiteId::Aes256Gcm) {
        EVP_CIPHER_CTX *context = keyed(EVP_CIPHER_fetch(nullptr, "AES-256-GCM", nullptr), m);
        return [&m, context, written](std::size_t n) mutable {
            EVP_EncryptInit_ex2(context, nullptr, nullptr, m.nonce.data(), nullptr);
            EVP_EncryptUpdate(context, nullptr, &written, m.associated.data(), static_cast<int>(m.associated.size()));
            EVP_EncryptUpdate(context, m.text.data(), &written, m.text.data(), static_cast<int>(n));
            EVP_EncryptFinal_ex(context, m.tag.data(), &written);
            EVP_CIPHER_CTX_ctrl(context, EVP_CTRL_AEAD_GET_TAG, 16, m.tag.data());
        };
    }
    const bool blocks = suite == SuiteId::Aes256Cbc;
    return [cipher = bareCipher(suite, m), &m, blocks](std::size_t n) {
        cipher(n);
        m.hmac(blocks ? (n / 16 + 1) * 16 : n);
    };
}

/// As `open` is measured: from a fresh copy of sealed bytes, since it works in place.
BareCall bareOpen(SuiteId suite, Material &m)
{
    int written = 0;
    if (suite == SuiteId::ChaCha20Poly1305) {
        return [&m, sealed = std::array<std::uint8_t, 512>{}, sealedSize = std::size_t(0)](std::size_t n) mutable {
            if (sealedSize != n) {
                crypto_aead_chacha20poly1305_ietf_encrypt(sealed.data(), nullptr, sealed.data(), n, m.associated.data(),
                                                          m.associated.size(), nullptr, m.nonce.data(), m.key.data());
                sealedSize = n;
            }
            std::copy_n(sealed.begin(), n + 16, m.text.begin());
            if (crypto_aead_chacha20poly1305_ietf_decrypt(m.text.data(), nullptr, nullptr, m.text.data(), n + 16, m.associated.data(),
                                                          m.associated.size(), m.nonce.data(), m.key.data()) != 0)
                std::abort();
        };
    }
    if (suite == SuiteId::Aes256Gcm) {
        EVP_CIPHER_CTX *context = keyed(EVP_CIPHER_fetch(nullptr, "AES-256-GCM", nullptr), m);
        return [&m, context, written, sealed = std::array<std::uint8_t, 512>{}](std::size_t n) mutable {
            std::copy_n(sealed.begin(), n + 16, m.text.begin());
            EVP_DecryptInit_ex2(context, nullptr, nullptr, m.nonce.data(), nullptr);
            EVP_CIPHER_CTX_ctrl(context, EVP_CTRL_AEAD_SET_TAG, 16, m.text.data() + n);
            EVP_DecryptUpdate(context, nullptr, &written, m.associated.data(), static_cast<int>(m.associated.size()));
            EVP_DecryptUpdate(context, m.text.data(), &written, m.text.data(), static_cast<int>(n));
            EVP_DecryptFinal_ex(context, m.tag.data(), &written); // refuses, which takes as long
        };
    }
    const bool blocks = suite == SuiteId::Aes256Cbc;
    return [cipher = bareCipher(suite, m, CipherUse::Decrypt), &m, blocks, sealed = std::array<std::uint8_t, 512>{}](std::size_t n) {
        const std::size_t size = blocks ? (n / 16 + 1) * 16 : n;
        std::copy_n(sealed.begin(), size + 16, m.text.begin());
        m.hmac(size);
        cipher(n);
    };
}

DirectionSecret benchSecret()
{
    DirectionSecret secret;
    secret.mutableView()[0] = 1;
    return secret;
}

/// Nanoseconds of one call, over a stretch of time that is short enough to be left undisturbed now and then.
template<typename Call> double nanoseconds(Call &&call)
{
    constexpr int kCalls = 2000;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kCalls; ++i) {
        call(static_cast<std::uint64_t>(i));
        benchmark::ClobberMemory();
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    return taken.count() / kCalls;
}

struct OpenBench
{
    std::unique_ptr<RecordCipher> cipher;
    std::array<std::uint8_t, kAssociatedSize> associated{};
    std::vector<std::vector<std::uint8_t>> records;
    std::array<std::uint8_t, 512> work{};
    std::uint64_t failures = 0;

    OpenBench(SuiteId suite, std::size_t size) : cipher(makeRecordCipher(suite, benchSecret()))
    {
        const std::vector<std::uint8_t> plaintext(size, 7);
        for (std::uint64_t counter = 0; counter < 64; ++counter) {
            records.emplace_back(cipher->sealedSize(size));
            cipher->seal(counter, associated, plaintext, records.back());
        }
    }

    void operator()(std::uint64_t i)
    {
        const auto &record = records[i % 64];
        std::copy(record.begin(), record.end(), work.begin());
        failures += !cipher->open(i % 64, associated, MutableByteView(work).first(record.size()));
    }
};

/// The table of ratios: bare and measured calls in turn, so that both meet the same machine.
int printRatios()
{
    std::printf("%-18s %5s %9s %9s %9s %9s %9s %7s %7s\n", "suite", "bytes", "cipher ns", "bare seal", "seal ns", "bare open",
                "open ns", "seal x", "open x");
    bool ok = true;
    for (const SuiteInfo &info : suites()) {
        if (info.id == SuiteId::None || !suiteAvailable(info.id))
            continue;
        for (const std::size_t size : kSizes) {
            Material m;
            const BareCall cipherCall = info.aead ? BareCall() : bareCipher(info.id, m);
            const BareCall sealCall = bareSeal(info.id, m);
            const BareCall openCall = bareOpen(info.id, m);
            const auto sealing = makeRecordCipher(info.id, benchSecret());
            const std::array<std::uint8_t, kAssociatedSize> associated{};
            OpenBench opening(info.id, size);
            double cipher = 1e9, bareSealed = 1e9, sealed = 1e9, bareOpened = 1e9, opened = 1e9;
            std::uint64_t counter = 0;
            for (int round = 0; round < 15; ++round) {
                if (cipherCall)
                    cipher = std::min(cipher, nanoseconds([&](std::uint64_t) { cipherCall(size); }));
                bareSealed = std::min(bareSealed, nanoseconds([&](std::uint64_t) { sealCall(size); }));
                sealed = std::min(sealed, nanoseconds([&](std::uint64_t) {
                    sealing->seal(counter++, associated, MutableByteView(m.text).first(size), m.text);
                }));
                bareOpened = std::min(bareOpened, nanoseconds([&](std::uint64_t) { openCall(size); }));
                opened = std::min(opened, nanoseconds(std::ref(opening)));
            }
            ok = ok && opening.failures == 0;
            std::printf("%-18s %5zu %9.1f %9.1f %9.1f %9.1f %9.1f %7.2f %7.2f\n", std::string(info.name).c_str(), size,
                        cipherCall ? cipher : 0.0, bareSealed, sealed, bareOpened, opened, sealed / bareSealed, opened / bareOpened);
        }
    }
    return ok ? 0 : 1;
}

void seal(benchmark::State &state, SuiteId suite)
{
    const auto cipher = makeRecordCipher(suite, benchSecret());
    std::array<std::uint8_t, kAssociatedSize> associated{};
    std::array<std::uint8_t, 512> text{};
    const auto size = static_cast<std::size_t>(state.range(0));
    std::uint64_t counter = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(cipher->seal(counter++, associated, MutableByteView(text).first(size), text));
}

void open(benchmark::State &state, SuiteId suite)
{
    OpenBench bench(suite, static_cast<std::size_t>(state.range(0)));
    std::uint64_t i = 0;
    for (auto _ : state)
        bench(i++);
    if (bench.failures > 0)
        state.SkipWithError("a record did not open");
}

void bareSealing(benchmark::State &state, SuiteId suite)
{
    Material m;
    const BareCall call = bareSeal(suite, m);
    for (auto _ : state) {
        call(static_cast<std::size_t>(state.range(0)));
        benchmark::ClobberMemory();
    }
}

} // namespace

int main(int argc, char **argv)
{
    if (!initCrypto())
        return 1;
    for (const SuiteInfo &info : suites()) {
        if (info.id == SuiteId::None || !suiteAvailable(info.id))
            continue;
        for (const std::size_t size : kSizes) {
            const std::string name(info.name);
            const auto bytes = static_cast<std::int64_t>(size);
            benchmark::RegisterBenchmark(("bare_seal/" + name).c_str(), bareSealing, info.id)->Arg(bytes);
            benchmark::RegisterBenchmark(("seal/" + name).c_str(), seal, info.id)->Arg(bytes);
            benchmark::RegisterBenchmark(("open/" + name).c_str(), open, info.id)->Arg(bytes);
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return printRatios();
}
