// Resolves a host to an address without blocking: literals at once, names through the system's resolver.
#pragma once

#include "core/base/path.h"

#include <QtNetwork/QHostInfo>

#include <functional>
#include <optional>
#include <string>

namespace skyseal::link {

class HostLookup : public QObject
{
public:
    using Answer = std::function<void(std::optional<Address>)>;

    ~HostLookup() override { abort(); }

    /// Calls `answer` with the address, or nullopt when the name cannot be resolved. For a literal it is called before
    /// start() returns. Cancels a lookup that is running.
    void start(const std::string &host, std::uint16_t port, Answer answer);
    void abort();
    bool isRunning() const { return m_id >= 0; }

private:
    void finish(const QHostInfo &info, std::uint16_t port);

    int m_id = -1;
    Answer m_answer;
};

} // namespace skyseal::link
