// The account of what an engine exchanges with each address: to one that has proved nothing it sends at most as much as came
// from there, so that forged sources gain nothing.
#pragma once

#include "core/base/bytes.h"
#include "core/base/path.h"
#include "tests/fuzz/oracle.h"

#include <cstdint>
#include <map>
#include <utility>

namespace skyseal::test {

/// The first byte of the message of the channel that a block carries, in the form in which ends write it; 0 if it carries none.
inline std::uint8_t messageHead(Carrier carrier, ByteView block)
{
    constexpr std::size_t kTunnelPayload = 15; // behind ten bytes of head and five of TUNNEL
    std::size_t at = 0;
    if (carrier == Carrier::Tunnel)
        at = kTunnelPayload;
    else if (carrier == Carrier::Serial) // the code byte of COBS, behind a zero if a handshake or pairing begins
        at = !block.empty() && block[0] == 0 ? 2 : 1;
    return at < block.size() && block[at] >= 0x50 && block[at] <= 0x5f ? block[at] : 0;
}

inline bool isRecordHead(std::uint8_t head)
{
    return head >= 0x50 && head <= 0x57;
}
inline constexpr std::uint8_t kAnnouncementHead = 0x58, kFirstHead = 0x59, kAnswerHead = 0x5a, kCallHead = 0x5c,
                              kPairingAnswerHead = 0x5e, kPairingSealedHead = 0x5f;

class Exchanges
{
public:
    void received(LinkId link, const Address &from, std::size_t bytes) { m_all[{link, from}].in += bytes; }
    bool hasReceived(LinkId link, const Address &from) const { return m_all.contains({link, from}); }
    /// The address has proved more than that it sends.
    void proved(LinkId link, const Address &from) { m_all[{link, from}].isProved = true; }
    bool hasProved(LinkId link, const Address &from) const
    {
        const auto found = m_all.find({link, from});
        return found != m_all.end() && found->second.isProved;
    }
    void sent(LinkId link, const Address &to, std::size_t bytes)
    {
        Exchange &exchange = m_all[{link, to}];
        exchange.out += bytes;
        if (!exchange.isProved && exchange.out > exchange.in)
            violated("no more out than in");
    }

private:
    struct Exchange
    {
        std::size_t in = 0, out = 0;
        bool isProved = false;
    };

    std::map<std::pair<LinkId, Address>, Exchange> m_all;
};

} // namespace skyseal::test
