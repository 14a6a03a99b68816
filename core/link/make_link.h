// From a URL to the link that serves it.
#pragma once

#include "core/link/link.h"

#include <memory>

namespace skyseal::link {

/// A closed link; call open(). Must be made on the thread that it will live on. The listener must outlive it.
std::unique_ptr<Link> makeLink(const LinkUrl &url, LinkId id, LinkListener &listener, const LinkOptions &options = {});

} // namespace skyseal::link
