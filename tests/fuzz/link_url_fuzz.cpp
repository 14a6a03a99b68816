// The parser of link URLs: any text gives a URL whose canonical text parses back to it, or an error with a place.
#include "core/link/link_url.h"

#include "core/base/bytes.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    using skyseal::link::LinkUrl;
    const std::string_view text = skyseal::asText({data, size});
    const auto url = LinkUrl::parse(text);
    if (!url) {
        if (url.error().message.empty() || url.error().column == 0 || url.error().column > size + 1)
            std::abort();
        return 0;
    }
    const auto again = LinkUrl::parse(url->toText());
    if (!again || !(*again == *url))
        std::abort();
    return 0;
}
