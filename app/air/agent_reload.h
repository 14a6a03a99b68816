// Reads the configuration of a running agent again (SIGHUP). The suites that it offers change at once, and no session ends;
// what else has changed is named, since it takes a restart. A wrong configuration changes nothing.
#pragma once

#include "app/air/agent_options.h"

#include <QtCore/QStringList>

namespace skyseal::app {

class AgentReload
{
public:
    /// `arguments`: of the program. `inForce`: what it runs with.
    AgentReload(QStringList arguments, AgentSetup inForce) : m_arguments(std::move(arguments)), m_inForce(std::move(inForce)) {}

    /// Reports the outcome on stderr. Returns the policy if it has changed.
    std::optional<channel::Policy> changedPolicy();

private:
    const QStringList m_arguments;
    AgentSetup m_inForce;
};

} // namespace skyseal::app
