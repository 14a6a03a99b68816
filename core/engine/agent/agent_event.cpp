#include "core/engine/agent/agent_event.h"

template struct skyseal::CompiledOnce<skyseal::engine::AgentEventVariant>;
