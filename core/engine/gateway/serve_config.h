// The configuration of one link on which a gateway serves other ground stations and programs.
#pragma once

#include "core/engine/gateway/write_rights.h"
#include "core/link/link_url.h"

#include <QtNetwork/QHostAddress>

#include <bitset>
#include <string>
#include <string_view>
#include <utility>

namespace skyseal::engine {

struct ServeConfig
{
    /// "URL[,OPTION=VALUE…]": write=none|all|CLASS,…; from=ADDRESS/PREFIX (listening links only); sysid=ID,…; name=NAME. A
    /// listening link without a host listens on the loopback interface. `unnamed`: the rights where write= is missing. The
    /// error names the invalid part.
    static Result<ServeConfig, Reason> parse(std::string_view text, const WriteRights &unnamed = {});

    /// Whether a client with this address is accepted.
    bool isFrom(const Address &remote) const;
    /// Whether the configuration permits a client to use this system id.
    bool maySpeakAs(std::uint8_t systemId) const { return systems.none() || systems.test(systemId); }
    /// Whether programs of other machines can become clients.
    bool isOpenToOthers() const;

    link::LinkUrl url;
    WriteRights write = {};
    std::optional<std::pair<QHostAddress, int>> from = {}; ///< network and length of its prefix; anyone if empty
    std::bitset<256> systems = {};                         ///< none: any
    std::string name = {};                                 ///< shown to people; the URL if not given
};

} // namespace skyseal::engine
