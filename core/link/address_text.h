// Text of transport addresses, and the step between ours and Qt's. IPv4 is kept mapped into IPv6 (base/path.h) and
// written as people know it.
#pragma once

#include "core/base/path.h"

#include <QtNetwork/QHostAddress>

#include <optional>
#include <string>
#include <string_view>

namespace skyseal::link {

/// "1.2.3.4:14550" or "[::1]:14550".
std::string toText(const Address &address);
/// The host part alone: "1.2.3.4" or "::1", without brackets.
std::string hostText(const Address &address);

/// The reverse of toText; nullopt for anything else (names are not looked up).
std::optional<Address> parseAddress(std::string_view text);
/// Strict dotted decimal IPv4 or an IPv6 literal without brackets and scope, joined with `port`.
std::optional<Address> parseHost(std::string_view host, std::uint16_t port);

bool isIpv4(const Address &address);
/// 0.0.0.0 or ::.
bool isAnyAddress(const Address &address);
Address ipv4(std::uint32_t hostOrder, std::uint16_t port);

Address fromQt(const QHostAddress &host, std::uint16_t port);
QHostAddress toQt(const Address &address);

} // namespace skyseal::link
