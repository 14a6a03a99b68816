#include "core/link/make_link.h"

#if defined(SKYSEAL_HAVE_SERIAL)
#include "core/link/serial_link.h"
#endif
#include "core/link/tcp_link.h"
#include "core/link/tcp_server_link.h"
#include "core/link/tlog_link.h"
#include "core/link/udp_link.h"
#include "core/link/unsupported_link.h"

namespace skyseal::link {

std::unique_ptr<Link> makeLink(const LinkUrl &url, LinkId id, LinkListener &listener, const LinkOptions &options)
{
    switch (url.scheme()) {
    case LinkScheme::UdpIn:
    case LinkScheme::UdpOut: return std::make_unique<UdpLink>(url, id, listener, options);
    case LinkScheme::Tcp: return std::make_unique<TcpLink>(url, id, listener, options);
    case LinkScheme::TcpIn: return std::make_unique<TcpServerLink>(url, id, listener, options);
    case LinkScheme::Tlog: return std::make_unique<TlogLink>(url, id, listener, options);
    case LinkScheme::Serial: break;
    }
#if defined(SKYSEAL_HAVE_SERIAL)
    return std::make_unique<SerialLink>(url, id, listener, options);
#else
    return std::make_unique<UnsupportedLink>(url, id, listener, options);
#endif
}

} // namespace skyseal::link
