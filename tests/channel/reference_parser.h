// How the reference implementation of MAVLink takes a stream apart, byte by byte, as far as it matters here: a frame that
// claims an incompatibility flag it does not know is given up at that very byte, and the search for the next magic goes on
// behind it, in the middle of the frame. https://mavlink.io/en/guide/serialization.html#incompat_flags
#pragma once

#include "core/channel/message_traits.h"

#include <functional>

namespace skyseal::test {

class ReferenceParser
{
public:
    ReferenceParser(const channel::MessageTraits &facts, std::function<void(ByteView)> deliver)
        : m_facts(&facts), m_deliver(std::move(deliver))
    {}

    void feed(ByteView bytes)
    {
        for (const std::uint8_t byte : bytes)
            take(byte);
    }

private:
    void take(std::uint8_t byte)
    {
        if (m_frame.empty() && byte != 0xfd && byte != 0xfe)
            return;
        m_frame.push_back(byte);
        const bool v2 = m_frame[0] == 0xfd;
        if (v2 && m_frame.size() == 3 && (byte & ~0x01) != 0)
            return m_frame.clear();
        const std::size_t header = v2 ? 10 : 6;
        if (m_frame.size() < header)
            return;
        const std::size_t checked = header + m_frame[1] + 2;
        if (m_frame.size() == checked && !checksumIsRight(header))
            return m_frame.clear();
        if (m_frame.size() < checked + (v2 && (m_frame[2] & 1) ? 13 : 0))
            return;
        m_deliver(m_frame);
        m_frame.clear();
    }

    bool checksumIsRight(std::size_t header) const
    {
        const std::uint32_t id = header == 10 ? std::uint32_t(m_frame[7] | m_frame[8] << 8 | m_frame[9] << 16) : m_frame[5];
        const auto message = m_facts->message(id);
        const std::size_t end = header + m_frame[1];
        return message
            && m_facts->checksum(ByteView(m_frame).subspan(1, end - 1), message->crcExtra)
            == (m_frame[end] | m_frame[end + 1] << 8);
    }

    const channel::MessageTraits *m_facts;
    std::function<void(ByteView)> m_deliver;
    Bytes m_frame;
};

} // namespace skyseal::test
