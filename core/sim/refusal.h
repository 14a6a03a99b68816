// Reason of a refused request, as a sentence for the operator; nullopt if it was accepted.
#pragma once

#include <optional>
#include <string>

namespace skyseal::sim {

using Refusal = std::optional<std::string>;

} // namespace skyseal::sim
