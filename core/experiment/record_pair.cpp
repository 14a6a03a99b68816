#include "core/experiment/record_pair.h"

#include "core/channel/endpoint.h"
#include "core/crypto/x25519.h"

#include <algorithm>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace skyseal::experiment {

namespace {

constexpr std::size_t kStation = 0, kAgent = 1;
constexpr Duration kStep = std::chrono::milliseconds(10);

channel::Policy allSuites()
{
    channel::Policy policy;
    policy.suites = channel::defaultSuites();
    policy.allowResearch = true;
    return policy;
}

} // namespace

std::optional<std::size_t> heapInUse()
{
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return std::nullopt;
#endif
}

RecordPair::~RecordPair() = default;

RecordPair::RecordPair()
{
    std::array<std::shared_ptr<crypto::X25519KeyPair>, 2> keys;
    for (auto &key : keys)
        key = std::make_shared<crypto::X25519KeyPair>(crypto::X25519KeyPair::generate(m_random));
    for (const std::size_t end : {kStation, kAgent}) {
        m_paths[end].link = LinkId{1};
        m_paths[end].remote.ip[15] = static_cast<std::uint8_t>(end + 1);
        m_paths[end].remote.port = 14550;
    }
    for (const std::size_t end : {kStation, kAgent}) {
        channel::Config config;
        config.role = end == kStation ? channel::Role::Station : channel::Role::Agent;
        config.identity = keys[end];
        channel::Peer peer;
        peer.key = keys[1 - end]->publicKey;
        peer.name = "peer";
        config.peers.push_back(std::move(peer));
        config.policy = allSuites();
        if (end == kAgent)
            config.announceTo.push_back(m_paths[kStation]);
        m_ends[end] = std::make_unique<channel::Endpoint>(std::move(config), m_random, m_counters[end], m_now);
    }
}

std::unique_ptr<RecordPair> RecordPair::create(crypto::SuiteId suite)
{
    auto pair = std::make_unique<RecordPair>();
    return pair->connect(suite) ? std::move(pair) : nullptr;
}

bool RecordPair::connect(crypto::SuiteId suite)
{
    run(std::chrono::seconds(2));
    if (m_ends[kStation]->sessions().empty())
        return false;
    if (!bothUse(suite))
        m_ends[kStation]->switchSuite(m_now, m_ends[kStation]->sessions().front(), suite);
    run(std::chrono::seconds(6)); // until the previous epoch has expired
    return bothUse(suite);
}

bool RecordPair::bothUse(crypto::SuiteId suite) const
{
    return std::all_of(m_ends.begin(), m_ends.end(), [suite](const auto &end) {
        const auto sessions = end->sessions();
        return sessions.size() == 1 && end->sessionInfo(sessions.front())->suite == suite;
    });
}

void RecordPair::run(Duration span)
{
    for (const TimePoint stop = m_now + span; m_now < stop; m_now += kStep) {
        for (auto &end : m_ends) {
            if (end->nextDeadline() <= m_now)
                end->handleDeadline(m_now);
        }
        exchange();
    }
}

void RecordPair::exchange()
{
    bool any = true;
    while (any) {
        any = false;
        for (const std::size_t from : {kStation, kAgent}) {
            while (const auto transmit = m_ends[from]->pollTransmit()) {
                Bytes datagram(transmit->bytes.begin(), transmit->bytes.end());
                m_ends[1 - from]->handleDatagram(m_now, m_paths[from], datagram);
                any = true;
            }
            while (m_ends[from]->pollEvent()) {}
        }
    }
}

std::size_t RecordPair::seal(ByteView frames, MutableByteView out)
{
    return m_ends[kAgent]->seal(m_now, m_ends[kAgent]->sessions().front(), frames, out).value_or(0);
}

bool RecordPair::open(MutableByteView record)
{
    return m_ends[kStation]->handleDatagram(m_now, m_paths[kAgent], record).has_value();
}

} // namespace skyseal::experiment
