#include "core/channel/cobs.h"

#include <utility>

namespace skyseal::channel {

std::size_t writeCobs(ByteView message, MutableByteView out)
{
    if (message.empty() || message.size() > kMaxDatagram)
        return 0;
    const bool opens = isOurs(message[0]) && kindOf(message[0]) >= DatagramKind::Handshake;
    const std::size_t most = message.size() + message.size() / 254 + 1 + 1 + (opens ? 1 : 0);
    if (out.size() < most)
        return 0;
    std::size_t at = 0;
    if (opens)
        out[at++] = 0;
    std::size_t code = at++;
    std::uint8_t run = 1;
    for (std::size_t i = 0; i < message.size(); ++i) {
        if (message[i] != 0) {
            out[at++] = message[i];
            ++run;
        }
        // A full block stands for no zero. Nothing follows it if the message ends there.
        const bool full = run == 0xff && message[i] != 0;
        if (message[i] == 0 || (full && i + 1 < message.size())) {
            out[code] = std::exchange(run, std::uint8_t(1));
            code = at++;
        }
    }
    out[code] = run;
    out[at++] = 0;
    return at;
}

void CobsReader::take(std::uint8_t byte)
{
    m_begun = true;
    if (m_bad)
        return;
    if (m_left == 0) {
        if (m_zeroDue && m_size == m_message.size()) {
            m_bad = true;
            return;
        }
        if (m_zeroDue)
            m_message[m_size++] = 0;
        m_zeroDue = byte != 0xff;
        m_left = static_cast<std::uint8_t>(byte - 1);
        return;
    }
    if (m_size == m_message.size()) {
        m_bad = true;
        return;
    }
    m_message[m_size++] = byte;
    --m_left;
}

std::size_t CobsReader::end()
{
    const bool whole = m_begun && !m_bad && m_left == 0 && m_size > 0;
    if (m_begun && !whole)
        ++m_damaged;
    m_left = 0;
    m_zeroDue = false;
    m_begun = false;
    m_bad = false;
    return std::exchange(m_size, 0) * (whole ? 1 : 0);
}

} // namespace skyseal::channel
