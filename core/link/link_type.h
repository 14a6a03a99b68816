// Descriptor of a link type: scheme and form of its URLs, traits, texts for people, factory. The table in link_type.cpp is the
// only list of types; the URL parser, makeLink(), the window's dialog, the programs' --help and the
// manual page derive from it.
#pragma once

#include "core/base/path.h"
#include "core/link/link_traits.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace skyseal::link {

class Link;
class LinkListener;
class LinkUrl;
struct LinkOptions;

/// Form of the part of a URL after the scheme.
enum class LinkTarget : std::uint8_t {
    HostPort,   ///< network address; optional host for a listening link
    DeviceBaud, ///< serial device and its rate in bit/s
    File,
};

struct LinkType
{
    const char *scheme; ///< lower case, without the colon
    LinkTarget target;
    LinkTraits traits; ///< all but isSlow, which depends on the rate of the URL
    const char *label; ///< English; translate in the context kTextContext
    const char *hint;  ///< one English sentence, translated like the label
    std::unique_ptr<Link> (*make)(const LinkUrl &, LinkId, LinkListener &, const LinkOptions &); ///< null: not in this build
    std::uint32_t defaultBaud = 0;                                                               ///< of DeviceBaud

    static constexpr const char *kTextContext = "skyseal::link::LinkType";

    /// The form of its URLs, for help and errors: "udpin:HOST:PORT".
    std::string syntax() const;
};

/// All types in the order of their display. Static lifetime.
std::span<const LinkType> linkTypes();
/// The type of a scheme in upper or lower case; null when there is none.
const LinkType *findLinkType(std::string_view scheme, std::span<const LinkType> types = linkTypes());

/// The forms of the URLs that `accepted` accepts (all when it is null): "udpin:HOST:PORT, udpout:HOST:PORT or tlog:FILE".
std::string linkForms(bool (*accepted)(const LinkTraits &) = nullptr);

} // namespace skyseal::link
