// A client of an MQTT broker (MQTT 3.1.1, by libmosquitto) that only publishes. It never subscribes and has no handler for
// messages, so that whatever a broker sends is dropped: no command reaches a vehicle this way.
//
// All calls of the library are made by one thread of this class. Looking up the host's name may block it for seconds, which
// must stop neither the I/O thread nor the main thread, whose life the service manager watches; and TLS costs time that the
// links need. It wakes twenty times a second: messages wait for up to 50 ms, and go out together. A message that was taken
// from PublishQueue is in the library's own queue, which has no bound; so no more is taken while kMostUnsent bytes or
// kMostUnconfirmed events are there.
#pragma once

#include "core/base/result.h"
#include "core/mqtt/message_sink.h"
#include "core/mqtt/publisher_config.h"

#include <memory>

namespace skyseal::mqtt {

class Publisher final : public MessageSink
{
public:
    static constexpr std::size_t kMostUnsent = 64 * 1024;
    static constexpr std::size_t kMostUnconfirmed = 20;
    /// The broker announces the gateway offline when it has heard nothing for one and a half times as long.
    static constexpr int kKeepAliveSeconds = 15;

    /// Reads the files, starts the thread and returns; the connection is made, and made again, by the thread. Fails if a file
    /// cannot be used, or if this build has no MQTT.
    static Result<std::unique_ptr<Publisher>, InputError> create(const PublisherConfig &config);
    /// Publishes what waits and the state "offline", for a second at most, and disconnects. Takes longer only while the name
    /// of the host is looked up.
    ~Publisher() override;

    void putState(std::string topic, std::string payload) override;
    void putEvent(std::string topic, std::string payload) override;
    void putRaw(std::uint8_t systemId, ByteView frame) override;
    PublisherStatus status() const override;

private:
    class Connection;
    explicit Publisher(std::unique_ptr<Connection> connection);
    std::unique_ptr<Connection> m_connection;
};

} // namespace skyseal::mqtt
