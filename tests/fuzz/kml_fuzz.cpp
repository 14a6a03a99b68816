// Any bytes as a KML file that is to be drawn over the map: read or refused, soon and without harm.
#include "core/overlay/kml_reader.h"
#include "overlay_oracle.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    skyseal::overlay::judge(skyseal::overlay::readKml(skyseal::overlay::contentOf(data, size)));
    return 0;
}
