#include "core/link/make_link.h"

#include "core/link/unsupported_link.h"

namespace skyseal::link {

std::unique_ptr<Link> makeLink(const LinkUrl &url, LinkId id, LinkListener &listener, const LinkOptions &options)
{
    if (!url.type().make)
        return std::make_unique<UnsupportedLink>(url, id, listener, options);
    return url.type().make(url, id, listener, options);
}

} // namespace skyseal::link
