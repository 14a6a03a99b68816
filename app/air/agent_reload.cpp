#include "app/air/agent_reload.h"

#include "app/common/journal.h"
#include "app/common/output.h"

namespace skyseal::app {

namespace {

/// The options that differ and take effect at a start only.
std::string needRestart(const AgentSetup &now, const AgentSetup &then)
{
    std::string out;
    const auto compare = [&out](const char *option, bool same) {
        if (!same)
            out.append(out.empty() ? "--" : ", --").append(option);
    };
    compare("vehicle", now.config.vehicle == then.config.vehicle);
    compare("ground", now.config.grounds == then.config.grounds);
    compare("identity", now.keys.identity == then.keys.identity);
    compare("peers", now.keys.peers == then.keys.peers);
    compare("allow-plain", now.config.allowPlain == then.config.allowPlain);
    compare("vehicle-signing", now.signing.keyFile == then.signing.keyFile);
    compare("accept-unsigned", now.signing.acceptUnsigned == then.signing.acceptUnsigned);
    compare("max-overtaken", now.config.freshness.overtaken == then.config.freshness.overtaken);
    compare("max-age", now.config.freshness.age == then.config.freshness.age);
    return out;
}

} // namespace

std::optional<channel::Policy> AgentReload::changedPolicy()
{
    Options options(QStringLiteral("skyseal-air"), {});
    declareAgent(options);
    std::optional<AgentSetup> read;
    if (!options.parse(m_arguments)) {
        read = readAgent(options);
        if (options.finish())
            read.reset();
    }
    if (!read) {
        remark("the configuration was not reloaded: the previous one stays in force", mavlink::MAV_SEVERITY_WARNING);
        return std::nullopt;
    }
    if (const std::string late = needRestart(m_inForce, *read); !late.empty())
        remark("reloaded; these options take effect after a restart: " + late);
    else
        remark("reloaded");
    channel::Policy policy = read->config.policy;
    policy.allowPlain = m_inForce.config.allowPlain;
    if (policy == m_inForce.config.policy)
        return std::nullopt;
    m_inForce.config.policy = policy;
    return policy;
}

} // namespace skyseal::app
