// Holds so many keyed ciphers, or pairs of ends with a session, of one suite, and says what each takes by our own measure: what
// a heap profiler sees of it beyond the same with fewer held is what it is checked against.
//
//     memory_probe contexts|pairs SUITE COUNT
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
    const bool inPairs = std::strcmp(argv[1], "pairs") == 0;
    const auto count = static_cast<std::size_t>(std::atoi(argv[3]));
    const double context = experiment::contextBytes(*suite).value_or(-1);
    experiment::RecordPair::create(*suite); // what the libraries keep from the first time is no pair's
    std::vector<std::unique_ptr<crypto::RecordCipher>> contexts;
    std::vector<std::unique_ptr<experiment::RecordPair>> pairs;
    contexts.reserve(count);
    pairs.reserve(count);
    const std::size_t before = experiment::heapInUse().value_or(0);
    for (std::size_t i = 0; i < count; ++i) {
        crypto::DirectionSecret secret;
        secret.mutableView()[0] = 1;
        if (inPairs)
            pairs.push_back(experiment::RecordPair::create(*suite));
        else
            contexts.push_back(crypto::makeRecordCipher(*suite, std::move(secret)));
    }
    const auto grown = static_cast<double>(experiment::heapInUse().value_or(0) - before);
    std::printf("%.1f\n", inPairs ? grown / static_cast<double>(count ? count : 1) : context);
    return 0;
}
