// Stands for publisher.cpp where libmosquitto was missing at build time.
#include "core/mqtt/publisher.h"

namespace skyseal::mqtt {

class Publisher::Connection
{};

Result<std::unique_ptr<Publisher>, InputError> Publisher::create(const PublisherConfig &config)
{
    return tl::unexpected(InputError{"this program was built without MQTT (libmosquitto)", config.broker.toText()});
}

Publisher::Publisher(std::unique_ptr<Connection> connection) : m_connection(std::move(connection)) {}

Publisher::~Publisher() = default;

void Publisher::putState(std::string, std::string) {}

void Publisher::putEvent(std::string, std::string) {}

void Publisher::putRaw(std::uint8_t, ByteView) {}

PublisherStatus Publisher::status() const
{
    return {};
}

} // namespace skyseal::mqtt
