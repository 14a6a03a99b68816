// The people at the two ends of a pairing, for tests with the real programs.
#pragma once

#include "tests/support/program.h"

namespace skyseal::test {

inline Program::Predicate stateIs(const char *state)
{
    return [state](const QJsonObject &event) { return event[QLatin1String("state")].toString() == QLatin1String(state); };
}

/// Confirms at the station (skyseal-cli keys pair --json) and, as a pilot, at the agent (skyseal-air --pair --json). Returns
/// false if the two did not see each other, or did not pair.
inline bool confirmAtBoth(Program &station, Program &agent)
{
    if (station.waitFor(QStringLiteral("pairing"), stateIs("seen")).isEmpty()
        || agent.waitFor(QStringLiteral("pairing"), stateIs("seen")).isEmpty())
        return false;
    station.notify(QStringLiteral("yes"));
    agent.notify(QStringLiteral("pilot"));
    return agent.waitForExit() == 0 && station.waitForExit() == 0;
}

} // namespace skyseal::test
