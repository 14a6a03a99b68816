// The far end of a sealed link without an engine: one endpoint on one plain socket, driven by hand. The test accounts for its
// cost, so that the engine on the other side can be measured alone.
#pragma once

#include "core/base/clock.h"
#include "core/channel/policy.h"
#include "core/channel/role.h"
#include "core/channel/session_id.h"
#include "core/channel/session_info.h"
#include "core/crypto/system_random.h"
#include "core/engine/common/secret_files.h"
#include "tests/channel/identity.h"
#include "tests/support/bare_socket.h"
#include "tests/support/volatile_counters.h"

#include <functional>
#include <memory>
#include <optional>

namespace skyseal::channel {
class Endpoint;
}

namespace skyseal::test {

/// Two ends that know each other's keys; no files.
struct Introduced
{
    Introduced();
    std::unique_ptr<engine::SecretFiles> secrets(channel::Role role) const;
    std::shared_ptr<const crypto::X25519KeyPair> ground, air;
};

class BareEnd
{
public:
    /// An agent announces itself to `groundPort`.
    BareEnd(const Introduced &keys, channel::Role role, channel::Policy policy, std::uint16_t groundPort = 0);
    BareEnd(std::unique_ptr<engine::SecretFiles> secrets, channel::Role role, channel::Policy policy,
            std::uint16_t groundPort = 0);
    ~BareEnd();

    std::uint16_t port() const { return m_socket.port(); }
    bool up() const { return m_session.has_value(); }
    channel::SessionId session() const { return *m_session; } ///< the newest
    /// Calls of its endpoint for that session.
    channel::SessionInfo sessionInfo() const;
    void switchSuite(crypto::SuiteId suite);
    void close();

    /// Handles all received datagrams, sends due messages, and returns the number of received MAVLink frames.
    std::size_t pump();
    /// Seals each of the frames into a record of its own and sends them.
    void sendEach(std::span<const ByteView> frames);
    /// Seals the frame without sending it.
    Bytes seal(ByteView frame);
    /// Opens a record of the peer in place, and returns its frames; empty if it is not accepted.
    ByteView open(TimePoint now, MutableByteView record);
    /// Called for each received MAVLink frame.
    std::function<void(ByteView frame)> frameReceived;
    /// Sends a datagram as it is.
    void send(ByteView datagram) { m_socket.send(m_peerPort, std::array{datagram}); }
    /// Waits for a datagram for at most this time.
    bool waitReadable(int milliseconds) { return m_socket.waitReadable(milliseconds); }
    bool waitReadable(Duration most) { return m_socket.waitReadable(most); }

private:
    void say();

    std::unique_ptr<engine::SecretFiles> m_secrets;
    std::unique_ptr<channel::Endpoint> m_endpoint;
    BareSocket m_socket;
    std::uint16_t m_peerPort;
    std::optional<channel::SessionId> m_session;
    std::vector<Bytes> m_records;
    std::vector<ByteView> m_views;
};

} // namespace skyseal::test
