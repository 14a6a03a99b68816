#include "core/engine/common/pairing_driver.h"

namespace skyseal::engine {

void PairingDriver::open(TimePoint now, channel::PairingConfig config)
{
    if (m_pairing) { // only the other end is informed: events from here on are about the new pairing
        m_pairing->cancel(now, channel::PairingEnd::Cancelled);
        while (const auto out = m_pairing->pollTransmit())
            m_links.send(out->to, out->bytes);
    }
    m_over = false;
    m_pairing.emplace(std::move(config), m_random, now);
}

bool PairingDriver::take(TimePoint now, const Path &from, ByteView datagram)
{
    if (!m_pairing || datagram.empty() || !channel::Pairing::owns(datagram[0]))
        return false;
    m_pairing->handleDatagram(now, from, datagram);
    return true;
}

void PairingDriver::handleDeadline(TimePoint now)
{
    if (m_pairing && m_pairing->nextDeadline() <= now)
        m_pairing->handleDeadline(now);
}

void PairingDriver::setCallTo(std::vector<Path> paths)
{
    if (m_pairing)
        m_pairing->setCallTo(std::move(paths));
}

void PairingDriver::confirm(TimePoint now, const channel::PublicKey &key)
{
    if (m_pairing)
        m_pairing->confirm(now, key);
}

void PairingDriver::refuse(TimePoint now)
{
    if (m_pairing)
        m_pairing->refuse(now);
}

void PairingDriver::cancel(TimePoint now, channel::PairingEnd reason)
{
    if (m_pairing)
        m_pairing->cancel(now, reason);
}

void PairingDriver::flush()
{
    if (!m_pairing)
        return;
    while (const auto out = m_pairing->pollTransmit())
        m_links.send(out->to, out->bytes);
    while (const auto event = m_pairing->pollEvent()) {
        m_over = m_over || std::holds_alternative<channel::PairingOver>(*event);
        m_notify(*event);
    }
    if (m_pairing->finished())
        m_pairing.reset();
}

} // namespace skyseal::engine
