// Makes the link that a URL describes.
#pragma once

#include "core/link/link.h"

#include <memory>

namespace skyseal::link {

/// Returns a closed link of the URL's type; call open(). For a type that is not in this build, the link fails on
/// open(). Call on the thread on which the link will live; `listener` must outlive the link.
std::unique_ptr<Link> makeLink(const LinkUrl &url, LinkId id, LinkListener &listener, const LinkOptions &options = {});

} // namespace skyseal::link
