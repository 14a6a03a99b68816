// Tells systemd that the service is ready, alive, and stopping (sd_notify(3)). Does nothing where no service manager asked for
// it (NOTIFY_SOCKET and WATCHDOG_USEC of the environment).
#pragma once

#include <QtCore/QTimer>

#include <functional>
#include <string>
#include <utility>

namespace skyseal::app {

/// Lives on the thread of the event loop whose life the watchdog follows.
class ServiceManager
{
public:
    ServiceManager();

    /// The watchdog follows other threads as well: it hears of this process only if the function returns true. It is called
    /// twice in each interval of the watchdog.
    void setAliveCheck(std::function<bool()> isAlive) { m_isAlive = std::move(isAlive); }

    /// The service is ready; from now on the watchdog hears of it as long as the event loop runs.
    void ready();
    void stopping();

private:
    void send(const std::string &state) const;

    const std::string m_socket; ///< empty: nobody listens
    std::function<bool()> m_isAlive = [] { return true; };
    QTimer m_alive;
};

} // namespace skyseal::app
