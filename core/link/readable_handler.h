// Interface between EpollDispatcher and the sockets that it calls directly, without an event of Qt.
#pragma once

namespace skyseal::link {

class ReadableHandler
{
public:
    /// The descriptor can be read, or reading it would report an error. Called again until nothing is left to read.
    virtual void handleReadable() = 0;

protected:
    ~ReadableHandler() = default;
};

} // namespace skyseal::link
