#include "core/mqtt/publisher.h"

#include "core/mqtt/connection.h"

namespace skyseal::mqtt {

Result<std::unique_ptr<Publisher>, InputError> Publisher::create(const PublisherConfig &config)
{
    auto connection = std::make_unique<Connection>(config);
    if (auto ready = connection->setUp(); !ready)
        return tl::unexpected(ready.error());
    connection->start();
    return std::unique_ptr<Publisher>(new Publisher(std::move(connection)));
}

Publisher::Publisher(std::unique_ptr<Connection> connection) : m_connection(std::move(connection)) {}

Publisher::~Publisher() = default;

void Publisher::putState(std::string topic, std::string payload)
{
    m_connection->put([&](PublishQueue &queue) { queue.putState(std::move(topic), std::move(payload)); });
}

void Publisher::putEvent(std::string topic, std::string payload)
{
    m_connection->put([&](PublishQueue &queue) { queue.putEvent(std::move(topic), std::move(payload)); });
}

void Publisher::putRaw(std::uint8_t systemId, ByteView frame)
{
    m_connection->put([&](PublishQueue &queue) { queue.putRaw(systemId, frame); });
}

PublisherStatus Publisher::status() const
{
    return m_connection->status();
}

} // namespace skyseal::mqtt
