// Transfers over a LossyLink: their content, their result, and the time that loss costs them.
#pragma once

#include "lossy_link.h"

#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>

namespace skyseal::vehicle {

inline Bytes noise(std::size_t size, unsigned seed = 1)
{
    std::mt19937 random(seed);
    Bytes out(size);
    for (std::uint8_t &byte : out)
        byte = static_cast<std::uint8_t>(random());
    return out;
}

/// Runs a request to its end.
template<typename Result> Result resultOf(Harness &h, LossyLink &link, const Request &request)
{
    h.vehicle.perform(h.now, RequestId{1}, request);
    std::optional<Result> result;
    if (!link.run(std::chrono::seconds(600), [&] { return (result = h.poll<Result>()).has_value(); }))
        return {.reason = "no result"};
    return *result;
}

/// With a tenth, and with a quarter of all messages lost, a transfer takes on average at most so many times as long as without
/// loss, which takes `clean` seconds.
inline void verifyCostOfLoss(const std::function<double(double loss, unsigned seed)> &timeToTransfer, double clean,
                             double factorOfTenth = 2, double factorOfQuarter = 3)
{
    constexpr unsigned kSeeds = 50;
    for (const auto &[loss, factor] : {std::pair(0.1, factorOfTenth), std::pair(0.25, factorOfQuarter)}) {
        double sum = 0, longest = 0;
        for (unsigned seed = 1; seed <= kSeeds; ++seed) {
            const double time = timeToTransfer(loss, seed);
            sum += time;
            longest = std::max(longest, time);
        }
        const std::string said = "loss " + std::to_string(loss) + ": mean " + std::to_string(sum / kSeeds) + " s, longest "
            + std::to_string(longest) + " s, clean " + std::to_string(clean) + " s";
        qInfo("%s", said.c_str());
        QVERIFY2(sum / kSeeds <= factor * clean, said.c_str());
    }
}

} // namespace skyseal::vehicle
