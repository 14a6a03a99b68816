#include "core/sim/flight_context.h"

namespace skyseal::sim {

FlightContext::FlightContext(const AutopilotConfig &config)
    : type(config.type), parameters(type), world(config.start), physics(type, config.seed, config.heading, config.firstFix),
      modes(world, type)
{
    physics.battery().replace(parameter("SIM_BATT_CAP_AH") * 1000, 1);
}

Situation FlightContext::situation() const
{
    return {estimate(), settings, pilot.sticks(), home.orOrigin(), returnPoint(), landed()};
}

Vector3 FlightContext::returnPoint() const
{
    if (rallyPoints.items().empty())
        return home.orOrigin();
    return rallyPoints.bestFor(estimate().position, home.orOrigin(), world, parameter("RALLY_LIMIT_KM") * 1000,
                               parameters.flag("RALLY_INCL_HOME"));
}

} // namespace skyseal::sim
