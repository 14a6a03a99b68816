// An autopilot in simulated time: the tests fly it by requests, with no MAVLink and no clock.
#pragma once

#include "core/sim/autopilot.h"

#include <functional>

namespace skyseal::sim {

struct TestFlight
{
    explicit TestFlight(const AutopilotConfig &config = {}) : autopilot(config) {}

    void run(double seconds)
    {
        for (auto end = autopilot.time() + static_cast<std::uint64_t>(seconds * 1e6); autopilot.time() < end;)
            step();
    }

    /// Runs until `condition` holds; the seconds it took, or -1 when it took longer than `limit`.
    double until(const std::function<bool()> &condition, double limit)
    {
        const auto begin = autopilot.time();
        while (!condition()) {
            if (autopilot.time() - begin > static_cast<std::uint64_t>(limit * 1e6))
                return -1;
            step();
        }
        return static_cast<double>(autopilot.time() - begin) * 1e-6;
    }

    /// Boots, and is in GUIDED at a height.
    bool airborne(double height)
    {
        return until([&] { return autopilot.estimate().positionOk; }, 10) >= 0
            && !autopilot.requests().enterMode(FlightMode::Guided) && !autopilot.arming().arm(false)
            && !autopilot.requests().takeOff(height)
            && until([&] { return autopilot.heightAboveHome() > height - 0.3; }, 60) >= 0;
    }

    bool said(std::string_view words) const
    {
        return std::any_of(texts.begin(), texts.end(),
                           [&](const PendingText &t) { return t.text.find(words) != std::string::npos; });
    }

    Autopilot autopilot;
    std::vector<PendingText> texts;
    double highest = 0; ///< m above home
    bool finite = true; ///< every state so far was made of numbers

private:
    void step()
    {
        autopilot.step();
        while (auto text = autopilot.texts().take())
            texts.push_back(std::move(*text));
        highest = std::max(highest, autopilot.heightAboveHome());
        const BodyState &truth = autopilot.truth();
        finite = finite && truth.position.finite() && truth.velocity.finite() && truth.rates.finite()
            && std::isfinite(truth.attitude.w()) && truth.attitude.vector().finite()
            && std::isfinite(autopilot.flight().physics.battery().voltage());
    }
};

} // namespace skyseal::sim
