// A station for tests: listens on a port of its own, or has the link that a test gives it.
#pragma once

#include "tests/engine/flight_rig.h"
#include "tests/support/eventually.h"

#include <QtTest/QTest>

namespace skyseal::test {

/// Of a station that knows nothing of sealing.
inline engine::StationConfig plainConfig()
{
    engine::StationConfig config;
    config.secure = engine::SecureMode::Off;
    config.record = false;
    return config;
}

struct Ground
{
    explicit Ground(engine::StationConfig config) : Ground(std::move(config), urlOf("udpin:127.0.0.1:0"))
    {
        if (!eventually([this] { return !ears->listening().empty(); }))
            qFatal("no link");
    }
    Ground(engine::StationConfig config, const link::LinkUrl &url)
    {
        auto made = engine::Station::create(std::move(config));
        if (!made)
            qFatal("%s", made.error().text().c_str());
        station = std::move(*made);
        ears = std::make_unique<StationEars>(*station);
        station->addLink(url);
    }
    quint16 port() const { return portOf(ears->listening()); }
    bool up() const { return !ears->all<channel::SessionUp>().empty(); }

    std::unique_ptr<engine::Station> station;
    std::unique_ptr<StationEars> ears;
};

} // namespace skyseal::test
