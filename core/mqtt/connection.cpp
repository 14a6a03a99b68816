#include "core/mqtt/connection.h"

#include "core/base/hex.h"
#include "core/base/json_writer.h"
#include "core/base/secret_bytes.h"
#include "core/keys/file_io.h"
#include "core/link/steady_now.h"
#include "core/mqtt/topics.h"

#include <mosquitto.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <netdb.h>
#include <poll.h>
#include <random>
#include <sys/socket.h>

namespace skyseal::mqtt {

namespace {

constexpr std::chrono::milliseconds kWake{50};
constexpr std::chrono::milliseconds kConnecting{20}; ///< between two looks at a connection that is being made
constexpr Duration kGoodbye = std::chrono::seconds(1);
/// Smaller than the kernel's default: newer states cannot replace those that wait in the kernel.
constexpr int kSendBuffer = 128 * 1024;

std::string gatewayState(const char *state)
{
    JsonWriter json;
    json.beginObject().field("event", "gateway").field("state", state).endObject();
    return json.text();
}

/// Brokers end the older of two connections with the same name, so each has its own.
std::string clientId()
{
    std::random_device random;
    const std::uint32_t number[] = {random(), random()};
    return "skyseal-" + toHex({reinterpret_cast<const std::uint8_t *>(number), 6});
}

} // namespace

Publisher::Connection::Connection(const PublisherConfig &config) : m_config(config), m_delay(std::random_device()())
{
    static const int initialized = mosquitto_lib_init();
    static_cast<void>(initialized);
    m_client.reset(mosquitto_new(clientId().c_str(), true, this));
}

void Publisher::Connection::Destroy::operator()(mosquitto *client) const
{
    mosquitto_destroy(client);
}

Publisher::Connection::~Connection()
{
    if (!m_thread.joinable())
        return;
    {
        const std::lock_guard lock(m_mutex);
        m_stopping = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

Result<void, InputError> Publisher::Connection::setUp()
{
    mosquitto *client = m_client.get();
    if (!client)
        return tl::unexpected(InputError{"libmosquitto cannot be used", m_config.broker.toText()});
    mosquitto_int_option(client, MOSQ_OPT_PROTOCOL_VERSION, MQTT_PROTOCOL_V311);
    mosquitto_int_option(client, MOSQ_OPT_TCP_NODELAY, 1);
    mosquitto_threaded_set(client, true); // calls of publish queue the message; mosquitto_loop() writes it
    if (m_config.broker.tls) {
        auto tls = makeTlsContext(m_config);
        if (!tls)
            return tl::unexpected(tls.error());
        m_tls = std::move(*tls);
        mosquitto_void_option(client, MOSQ_OPT_SSL_CTX, m_tls.get());
        mosquitto_int_option(client, MOSQ_OPT_SSL_CTX_WITH_DEFAULTS, 0); // the settings are complete
    }
    if (!m_config.loginFile.empty()) {
        if (auto set = setLogin(); !set)
            return set;
    }
    const std::string gone = gatewayState("offline");
    mosquitto_will_set(client, topic(kGatewayState).c_str(), static_cast<int>(gone.size()), gone.data(), 1, true);
    mosquitto_connect_callback_set(client, [](mosquitto *, void *self, int code) {
        auto &connection = *static_cast<Connection *>(self);
        if (code == 0)
            connection.accepted();
        else
            connection.m_refusal = mosquitto_connack_string(code);
    });
    mosquitto_publish_callback_set(client,
                                   [](mosquitto *, void *self, int id) { static_cast<Connection *>(self)->noteSent(id); });
    mosquitto_log_callback_set(client, [](mosquitto *, void *self, int level, const char *text) {
        if (level == MOSQ_LOG_ERR)
            static_cast<Connection *>(self)->m_refusal = text;
    });
    return {};
}

Result<void, InputError> Publisher::Connection::setLogin()
{
    auto content = keys::readFile(m_config.loginFile, keys::FileAccess::Private);
    if (!content)
        return tl::unexpected(content.error());
    const std::string_view text = asText(*content);
    const std::size_t userEnd = text.find('\n');
    const std::size_t passwordEnd = userEnd == std::string_view::npos ? userEnd : text.find('\n', userEnd + 1);
    const bool whole = userEnd != std::string_view::npos && userEnd != 0 && text.find('\0') == std::string_view::npos;
    int error = MOSQ_ERR_INVAL;
    if (whole) {
        // Ended by zeros in place, so that there is no further copy of the password here.
        content->push_back(0);
        char *user = reinterpret_cast<char *>(content->data());
        user[userEnd] = 0;
        if (passwordEnd != std::string_view::npos)
            user[passwordEnd] = 0;
        error = mosquitto_username_pw_set(m_client.get(), user, user + userEnd + 1);
    }
    wipeSecret(*content);
    if (error != MOSQ_ERR_SUCCESS)
        return tl::unexpected(
            InputError{"a user in the first line and a password in the second are expected", m_config.loginFile});
    return {};
}

void Publisher::Connection::start()
{
    m_thread = std::thread([this] {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, nullptr); // signals are for the main thread; SIGPIPE stays pending here
        pthread_setname_np(pthread_self(), "skyseal-mqtt");
        run();
    });
}

void Publisher::Connection::run()
{
    while (!m_stopping) {
        m_refusal.clear();
        const BrokerUrl &broker = m_config.broker;
        const int error = mosquitto_connect_async(m_client.get(), broker.host.c_str(), broker.port, kKeepAliveSeconds);
        if (error == MOSQ_ERR_SUCCESS)
            serve();
        else
            setProblem(problemOf(error));
        lost();
        if (!m_stopping)
            pause(m_delay.next());
    }
}

void Publisher::Connection::serve()
{
    const int socket = mosquitto_socket(m_client.get());
    ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
    while (!m_stopping) {
        if (const int error = mosquitto_loop(m_client.get(), static_cast<int>(kWake.count()), 1))
            return setProblem(problemOf(error));
        if (m_isAccepted)
            handOver();
        else if (isHopeless())
            return;
        else
            pause(kConnecting);
    }
    if (m_isAccepted)
        sayGoodbye();
}

/// The library retries the TLS handshake of a connection that was refused until the keep-alive time is over.
bool Publisher::Connection::isHopeless()
{
    pollfd look{mosquitto_socket(m_client.get()), 0, 0};
    if (::poll(&look, 1, 0) <= 0 || !(look.revents & (POLLERR | POLLHUP)))
        return false;
    int error = 0;
    socklen_t size = sizeof error;
    ::getsockopt(look.fd, SOL_SOCKET, SO_ERROR, &error, &size);
    setProblem(error ? std::strerror(error) : "the connection was refused or closed");
    return true;
}

/// Called by the library.
void Publisher::Connection::accepted()
{
    m_isAccepted = true;
    m_delay.reset();
    {
        const std::lock_guard lock(m_mutex);
        m_status.connected = true;
        m_status.problem.clear();
        ++m_status.connections;
    }
    sendGatewayState("online");
}

void Publisher::Connection::lost()
{
    m_isAccepted = false;
    const std::lock_guard lock(m_mutex);
    m_status.connected = false;
    // The library forgets these when it connects again; those that the broker has to confirm are sent again.
    std::erase_if(m_unsent, [this](const auto &message) {
        if (message.second.bytes == 0)
            return false;
        ++countOf(message.second.kind).dropped;
        return true;
    });
    m_unsentBytes = 0;
}

void Publisher::Connection::handOver()
{
    while (const auto message = next())
        send(*message);
}

std::optional<OutgoingMessage> Publisher::Connection::next()
{
    const std::lock_guard lock(m_mutex);
    std::optional<OutgoingMessage> out;
    if (m_unconfirmed < kMostUnconfirmed)
        out = m_queue.takeEvent();
    if (!out && m_unsentBytes < kMostUnsent)
        out = m_queue.takeOther();
    return out;
}

void Publisher::Connection::send(const OutgoingMessage &message)
{
    const bool isEvent = message.kind == Kind::Event;
    int id = 0;
    const int error = mosquitto_publish(m_client.get(), &id, topic(message.topic).c_str(),
                                        static_cast<int>(message.payload.size()), message.payload.data(), isEvent ? 1 : 0,
                                        message.kind == Kind::State);
    if (error != MOSQ_ERR_SUCCESS) {
        const std::lock_guard lock(m_mutex);
        ++countOf(message.kind).dropped;
        return;
    }
    const Unsent unsent{message.kind, isEvent ? 0 : message.topic.size() + message.payload.size()};
    m_unsent.insert_or_assign(id, unsent);
    m_unsentBytes += unsent.bytes;
    m_unconfirmed += isEvent;
}

/// Not counted: it is none of the vehicles'.
void Publisher::Connection::sendGatewayState(const char *state)
{
    const std::string payload = gatewayState(state);
    mosquitto_publish(m_client.get(), nullptr, topic(kGatewayState).c_str(), static_cast<int>(payload.size()), payload.data(),
                      1, true);
}

/// Called by the library when a message was written, or confirmed if it is an event.
void Publisher::Connection::noteSent(int id)
{
    const auto found = m_unsent.find(id);
    if (found == m_unsent.end())
        return;
    m_unsentBytes -= found->second.bytes;
    m_unconfirmed -= found->second.kind == Kind::Event;
    {
        const std::lock_guard lock(m_mutex);
        ++countOf(found->second.kind).sent;
    }
    m_unsent.erase(found);
}

void Publisher::Connection::sayGoodbye()
{
    const TimePoint end = steadyNow() + kGoodbye;
    const auto loop = [this] { return mosquitto_loop(m_client.get(), 10, 1) == MOSQ_ERR_SUCCESS; };
    handOver();
    while (!m_unsent.empty() && steadyNow() < end && loop())
        handOver();
    sendGatewayState("offline");
    mosquitto_disconnect(m_client.get());
    while (steadyNow() < end && loop())
        ;
}

std::string Publisher::Connection::problemOf(int error) const
{
    if (error == MOSQ_ERR_EAI)
        return std::string("the host is not known: ") + ::gai_strerror(errno);
    if (error == MOSQ_ERR_ERRNO)
        return std::strerror(errno);
    if (error == MOSQ_ERR_KEEPALIVE)
        return "the broker does not answer";
    std::string out = m_refusal.empty() ? mosquitto_strerror(error) : m_refusal;
    if (error == MOSQ_ERR_TLS) // "OpenSSL Error[0]: error:0A000086:SSL routines::certificate verify failed"
        out = "TLS: " + out.substr(out.rfind(':') == std::string::npos ? 0 : out.rfind(':') + 1);
    while (out.ends_with('.') || out.ends_with('\n'))
        out.pop_back();
    return out;
}

void Publisher::Connection::setProblem(std::string problem)
{
    const std::lock_guard lock(m_mutex);
    m_status.problem = std::move(problem);
}

PublishCount &Publisher::Connection::countOf(Kind kind)
{
    return kind == Kind::State ? m_status.state : kind == Kind::Event ? m_status.event : m_status.raw;
}

PublisherStatus Publisher::Connection::status() const
{
    const std::lock_guard lock(m_mutex);
    PublisherStatus out = m_status;
    out.state.dropped += m_queue.dropped(Kind::State);
    out.event.dropped += m_queue.dropped(Kind::Event);
    out.raw.dropped += m_queue.dropped(Kind::Raw);
    return out;
}

void Publisher::Connection::pause(Duration time)
{
    std::unique_lock lock(m_mutex);
    m_wake.wait_for(lock, time, [this] { return m_stopping.load(); });
}

} // namespace skyseal::mqtt
