// The packed parameter file, which a station reads from a vehicle and the simulated vehicle from a station: whatever it
// holds, it is read within its bounds, and what is read fits what the file says of itself.
#include "core/mavlink/enums.h"
#include "core/mavlink/packed_parameters.h"

#include <cstdlib>

using namespace skyseal;

namespace {

void expect(bool holds)
{
    if (!holds)
        std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const auto file = mavlink::parsePackedParameters(ByteView(data, size));
    if (!file)
        return 0;
    expect(file->parameters.size() == std::size_t(data[2]) + std::size_t(data[3]) * 256);
    expect(file->parameters.size() * 4 <= size); // an entry has at least four bytes
    for (const mavlink::PackedParameter &parameter : file->parameters) {
        expect(!parameter.name.empty() && parameter.name.size() <= 16);
        switch (parameter.type) {
        case mavlink::MAV_PARAM_TYPE_INT8: expect(parameter.value >= -128 && parameter.value <= 127); break;
        case mavlink::MAV_PARAM_TYPE_INT16: expect(parameter.value >= -32768 && parameter.value <= 32767); break;
        case mavlink::MAV_PARAM_TYPE_INT32:
        case mavlink::MAV_PARAM_TYPE_REAL32: break;
        default: expect(false);
        }
    }
    return 0;
}
