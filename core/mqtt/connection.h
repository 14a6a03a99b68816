// The thread behind Publisher, which makes all calls of libmosquitto.
#pragma once

#include "core/mqtt/publish_queue.h"
#include "core/mqtt/publisher.h"
#include "core/mqtt/reconnect_delay.h"
#include "core/mqtt/tls_context.h"

#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

struct mosquitto;

namespace skyseal::mqtt {

class Publisher::Connection
{
public:
    explicit Connection(const PublisherConfig &config);
    ~Connection();

    /// Reads the files. Call once, before start().
    Result<void, InputError> setUp();
    void start();

    /// Changes the queue under its lock.
    template<typename Act> void put(Act act)
    {
        const std::lock_guard lock(m_mutex);
        act(m_queue);
    }
    PublisherStatus status() const;

private:
    /// A message that the library holds.
    struct Unsent
    {
        Kind kind{};
        std::size_t bytes = 0; ///< 0 for those that the broker has to confirm
    };
    struct Destroy
    {
        void operator()(mosquitto *client) const;
    };

    Result<void, InputError> setLogin();
    void run();
    void serve();
    bool isHopeless();
    void accepted();
    void lost();
    void handOver();
    std::optional<OutgoingMessage> next();
    void send(const OutgoingMessage &message);
    void sendGatewayState(const char *state);
    void sayGoodbye();
    void noteSent(int id);
    void setProblem(std::string problem);
    std::string problemOf(int error) const;
    PublishCount &countOf(Kind kind);
    /// Returns early when the publisher ends.
    void pause(Duration time);
    std::string topic(const std::string &relative) const { return m_config.broker.prefix + '/' + relative; }

    const PublisherConfig m_config;
    std::unique_ptr<mosquitto, Destroy> m_client;
    TlsContext m_tls;

    mutable std::mutex m_mutex; ///< of the next three
    PublishQueue m_queue;
    PublisherStatus m_status;
    std::condition_variable m_wake;
    std::atomic<bool> m_stopping = false;

    // Of the thread.
    ReconnectDelay m_delay;
    std::map<int, Unsent> m_unsent; ///< by the library's message id
    std::size_t m_unsentBytes = 0, m_unconfirmed = 0;
    bool m_isAccepted = false;
    std::string m_refusal; ///< the broker's, or the library's last error message

    std::thread m_thread;
};

} // namespace skyseal::mqtt
