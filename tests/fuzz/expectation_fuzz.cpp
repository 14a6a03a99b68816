// Assertions and link conditions as a script may write them: any text is safe, and an error says where it is.
#include "core/base/bytes.h"
#include "core/experiment/expectation.h"

#include <cstdlib>

using namespace skyseal;
using namespace skyseal::experiment;

static void must(bool holds)
{
    if (!holds)
        std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string text(asText({data, size}));
    const auto parsed = Expectation::parse(text);
    if (!parsed) {
        must(!parsed.error().message.empty() && parsed.error().column >= 1 && parsed.error().column <= text.size() + 1);
    } else {
        must(parsed->text() == text);
        const auto lookup = [](Metric metric, crypto::SuiteId suite, auto, auto) {
            return static_cast<double>(metric) - static_cast<double>(suite);
        };
        const auto outcome = parsed->check({crypto::SuiteId::Aes256Gcm}, lookup);
        must(outcome.measured || !outcome.holds);
    }
    if (const auto condition = parseCondition(text))
        must(condition->settings.loss >= 0 && condition->settings.loss <= 1 && condition->settings.delay.count() >= 0);
    return 0;
}
