#include "tests/fuzz/remote_end.h"

#include "core/channel/endpoint.h"
#include "core/crypto/inline_cipher.h"
#include "core/crypto/passphrase.h"
#include "core/engine/common/dialect_traits.h"
#include "core/engine/common/sealed_in_place.h"
#include "core/mavlink/frame_intake.h"

#include <algorithm>

namespace skyseal::test {

namespace {

constexpr std::size_t kMostHistory = 32;
constexpr std::size_t kMostHeld = 500; ///< the attacker loses what comes after these, so that only the engine could grow

} // namespace

Address addressOf(std::size_t number)
{
    Address out;
    out.ip = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 10, 0, 0, static_cast<std::uint8_t>(number + 1)};
    out.port = static_cast<std::uint16_t>(14550 + number);
    return out;
}

std::shared_ptr<const crypto::Passphrase> passphraseOf(std::uint8_t choice)
{
    choice &= 3;
    if (choice == 0)
        return {};
    const std::uint8_t bytes[] = {'p', choice};
    return std::make_shared<const crypto::Passphrase>(*crypto::Passphrase::fromBytes(bytes));
}

Policy policyOf(std::uint8_t choice)
{
    Policy out{defaultSuites(), !(choice & 4), false, !(choice & 2), false};
    if (choice & 1) {
        out.preferInline = true;
        std::stable_partition(out.suites.begin(), out.suites.end(), crypto::mayBeInline);
    }
    return out;
}

RemoteEnd::RemoteEnd(Config config, std::vector<Way> ways, Node node, std::uint64_t seed, TimePoint now)
    : m_random(seed), m_config(std::move(config)), m_ways(std::move(ways))
{
    m_config.messageTraits = std::make_shared<engine::DialectTraits>(mavlink::Dialect::builtin());
    (m_config.role == Role::Agent ? m_config.announceTo : m_config.callAt) = called();
    m_endpoint = std::make_unique<Endpoint>(m_config, m_random, m_counters, now);
    m_writer.setNode(node);
}

RemoteEnd::~RemoteEnd() = default;

bool RemoteEnd::hasSession() const
{
    return !m_endpoint->sessions().empty();
}

std::vector<Path> RemoteEnd::called() const
{
    std::vector<Path> out;
    for (const Way &way : m_ways) {
        if (way.calls)
            out.push_back(way.engine);
    }
    return out;
}

// ---- what it sends

bool RemoteEnd::send(TimePoint now, const Bytes &frames, bool inRecord)
{
    for (const SessionId session : m_endpoint->sessions()) {
        Bytes out(frames.size() + kMaxRecordOverhead);
        auto size = m_endpoint->sealInline(now, session, inRecord ? ByteView() : ByteView(frames), out);
        if (!size)
            size = m_endpoint->seal(now, session, frames, out);
        if (size)
            transmit(m_endpoint->recordPath(session), ByteView(out).first(*size));
    }
    return hasSession();
}

void RemoteEnd::switchSuite(TimePoint now, std::uint8_t choice)
{
    for (const SessionId session : m_endpoint->sessions())
        m_endpoint->switchSuite(now, session, crypto::suites()[choice % crypto::suites().size()].id);
}

void RemoteEnd::close(TimePoint now, std::size_t mark)
{
    poll(now);
    for (const SessionId session : m_endpoint->sessions()) {
        m_endpoint->close(now, session);
        while (const auto out = m_endpoint->pollTransmit())
            transmit(out->to, out->bytes, mark);
    }
}

void RemoteEnd::openPairing(TimePoint now, std::string name, std::uint8_t systemId, std::uint8_t passphrase)
{
    PairingConfig config;
    config.role = m_config.role;
    config.identity = m_config.identity;
    config.name = std::move(name);
    config.systemId = systemId;
    config.passphrase = passphraseOf(passphrase);
    config.callTo = called();
    for (const Way &way : m_ways) {
        if (m_config.role == Role::Agent && !way.calls)
            config.listensOn.push_back(way.engine.link);
    }
    m_pairing.emplace(std::move(config), m_random, now);
    m_shown.reset();
}

bool RemoteEnd::confirmPairing(TimePoint now)
{
    if (m_pairing && m_shown)
        m_pairing->confirm(now, *m_shown);
    return m_pairing && m_shown;
}

void RemoteEnd::cancelPairing(TimePoint now)
{
    if (m_pairing)
        m_pairing->cancel(now);
}

void RemoteEnd::reconnect(TimePoint now, LinkId link)
{
    for (const Way &way : m_ways) {
        if (way.engine.link == link)
            m_reader.forget(way.engine);
    }
    m_endpoint->handleStreamBegan(now, link);
}

void RemoteEnd::setCalling(TimePoint now, bool calling)
{
    m_endpoint->setCallAt(now, calling ? called() : std::vector<Path>());
}

void RemoteEnd::handleDeadline(TimePoint now)
{
    m_endpoint->handleDeadline(now);
    if (m_pairing)
        m_pairing->handleDeadline(now);
}

void RemoteEnd::poll(TimePoint now)
{
    while (const auto out = m_endpoint->pollTransmit())
        transmit(out->to, out->bytes);
    while (m_endpoint->pollEvent())
        continue;
    if (!m_pairing)
        return;
    while (const auto out = m_pairing->pollTransmit())
        transmit(out->to, out->bytes);
    while (const auto event = m_pairing->pollEvent()) {
        if (const auto *seen = std::get_if<PairingPeerSeen>(&*event))
            m_shown = seen->peer.key;
        if (const auto *paired = std::get_if<Paired>(&*event)) {
            m_config.peers[0].presharedKey = paired->peer.presharedKey;
            m_endpoint->setPeers(now, m_config.peers);
        }
    }
}

void RemoteEnd::transmit(const Path &to, ByteView message, std::optional<std::size_t> closes)
{
    m_writer.write(to, message, [&](ByteView block) {
        if (m_queue.size() < kMostHeld)
            m_queue.push_back({Bytes(block.begin(), block.end()), closes, to.link});
    });
}

// ---- what it receives

void RemoteEnd::receive(TimePoint now, LinkId link, ByteView block)
{
    const auto way = std::ranges::find(m_ways, link, [](const Way &each) { return each.engine.link; });
    if (way == m_ways.end())
        return;
    Bytes bytes(block.begin(), block.end());
    const link::ReceivedBlock received{{link, way->engine.remote}, bytes, now};
    if (way->engine.carrier == Carrier::Serial) {
        m_reader.takeCobs(
            received, [&](ByteView message) { return m_endpoint->namesSerialSession(message); },
            [&](const link::ReceivedBlock &message) {
                handleMessage(now, message);
                return false; // this end does not ask whether the stream is COBS
            });
        return;
    }
    const bool datagrams = way->engine.carrier == Carrier::Datagram;
    if (datagrams && !bytes.empty() && Endpoint::owns(bytes[0]))
        return handleMessage(now, received);
    mavlink::scanFrames(block, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
        if (datagrams && engine::isSealedInPlace(item))
            m_endpoint->handleInlineFrame(now, received.path, received.bytes.subspan(item.offset, item.bytes.size()));
        if (datagrams || !engine::CarrierReader::isTunnel(item))
            return;
        if (const auto message = m_reader.takeTunnel(now, received.path, *item.frame, m_writer.node()))
            handleMessage(now, *message);
    });
}

void RemoteEnd::handleMessage(TimePoint now, const link::ReceivedBlock &message)
{
    if (Pairing::owns(message.bytes[0])) {
        if (m_pairing)
            m_pairing->handleDatagram(now, message.path, message.bytes);
    } else if (Endpoint::owns(message.bytes[0])) {
        m_endpoint->handleDatagram(now, message.path, message.bytes);
    }
}

// ---- the attacker

void RemoteEnd::hold(std::uint8_t how)
{
    m_isHeld = how & 1;
    if (how & 2)
        std::reverse(m_queue.begin(), m_queue.end());
    if (how & 4)
        m_queue.clear();
}

void RemoteEnd::withholdNewest()
{
    if (m_queue.empty())
        return;
    keep(std::move(m_queue.back()));
    m_queue.pop_back();
}

void RemoteEnd::keep(Block block)
{
    m_history.push_back(std::move(block));
    if (m_history.size() > kMostHistory)
        m_history.pop_front();
}

std::optional<RemoteEnd::Block> RemoteEnd::next()
{
    if (m_isHeld || m_queue.empty())
        return std::nullopt;
    keep(std::move(m_queue.front()));
    m_queue.pop_front();
    return m_history.back();
}

std::optional<RemoteEnd::Block> RemoteEnd::repeat(std::uint8_t choice) const
{
    if (m_history.empty())
        return std::nullopt;
    return m_history[m_history.size() - 1 - choice % m_history.size()];
}

std::optional<RemoteEnd::Block> RemoteEnd::changed(std::uint8_t at, std::uint8_t by) const
{
    if (m_history.empty())
        return std::nullopt;
    Block out{m_history.back().bytes, {}, m_history.back().link};
    out.bytes[at % out.bytes.size()] ^= static_cast<std::uint8_t>(1 + by % 255);
    return out;
}

std::optional<RemoteEnd::Block> RemoteEnd::cut(std::uint8_t length) const
{
    if (m_history.empty())
        return std::nullopt;
    Block out{m_history.back().bytes, {}, m_history.back().link};
    out.bytes.resize(length % out.bytes.size());
    return out;
}

} // namespace skyseal::test
