// The options of skyseal-air that describe the agent.
#pragma once

#include "app/common/options.h"
#include "core/engine/agent/agent_config.h"
#include "core/engine/common/key_paths.h"

#include <optional>
#include <string>

namespace skyseal::app {

/// MAVLink signing on the vehicle's side.
struct SigningSetup
{
    std::string keyFile; ///< empty: none
    bool acceptUnsigned = false;

    bool operator==(const SigningSetup &) const = default;
};

/// All that the options say of an agent.
struct AgentSetup
{
    engine::AgentConfig config;
    engine::KeyPaths keys;
    SigningSetup signing;
};

/// All options of the program.
void declareAgent(Options &options);
/// Records a problem and returns nothing if an option is wrong. Opens no file.
std::optional<AgentSetup> readAgent(Options &options);

} // namespace skyseal::app
