// Says on the command line when the connection to the broker is made, and why there is none.
#pragma once

#include <string>

namespace skyseal::engine {
struct Snapshot;
}

namespace skyseal::app {

class BrokerReport
{
public:
    BrokerReport(std::string url, bool json) : m_url(std::move(url)), m_json(json) {}

    /// Call for every snapshot.
    void take(const engine::Snapshot &snapshot);

private:
    const std::string m_url;
    const bool m_json;
    bool m_connected = false;
    std::string m_problem;
};

} // namespace skyseal::app
