// Holds so many keyed ciphers, or sessions between two ends, of one suite, and says what a cipher, or one end's session, takes
// by our own measure: what a heap profiler sees beyond the same with fewer held is what it is checked against.
//
//     memory_probe contexts|sessions SUITE COUNT
#include "core/base/secret_bytes.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"
#include "core/experiment/cipher_bench.h"
#include "core/experiment/record_pair.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

using namespace skyseal;

int main(int argc, char **argv)
{
    if (argc != 4 || !crypto::initCrypto())
        return 2;
    const auto suite = crypto::suiteFromName(argv[2]);
    if (!suite)
        return 2;
    const bool sessions = std::strcmp(argv[1], "sessions") == 0;
    constexpr std::size_t kPairs = 60;
    const auto count = static_cast<std::size_t>(std::atoi(argv[3]));
    const double ours = (sessions ? experiment::sessionBytes(*suite) : experiment::contextBytes(*suite)).value_or(-1);
    std::vector<std::unique_ptr<crypto::RecordCipher>> contexts;
    std::vector<experiment::RecordPair> pairs(sessions ? kPairs
                                                       : 0); // as many whatever the count: only sessions make a difference
    contexts.reserve(count);
    if (sessions && count > kPairs)
        return 2;
    for (std::size_t i = 0; i < count; ++i) {
        crypto::DirectionSecret secret;
        secret.mutableView()[0] = 1;
        if (sessions && !pairs[i].connect(*suite))
            return 1;
        if (!sessions)
            contexts.push_back(crypto::makeRecordCipher(*suite, std::move(secret)));
    }
    std::printf("%.1f\n", ours);
    return 0;
}
