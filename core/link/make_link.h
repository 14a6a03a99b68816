// Makes the link that a URL describes.
#pragma once

#include "core/link/link.h"

#include <memory>

namespace skyseal::link {

/// Returns a closed link of the URL's type; call open(). A type that this build leaves out gives a link that fails on
/// open(). Call on the thread that the link will live on; `listener` must outlive the link.
std::unique_ptr<Link> makeLink(const LinkUrl &url, LinkId id, LinkListener &listener, const LinkOptions &options = {});

} // namespace skyseal::link
