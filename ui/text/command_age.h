// How late the operator's commands arrive at the vehicle, as its agent reports. For the status strip and the secure link.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>

#include <optional>

namespace skyseal::ui {

struct CommandAge
{
    QString sentence; ///< for instance "Commands arrive up to 4.2 s late"
    QString brief;    ///< the same for the status strip
    QString limits;   ///< those of the agent
    bool late = false;
    bool ignored = false; ///< beyond the agent's limit
};

/// Returns nothing without a session, and before the first report of its agent.
std::optional<CommandAge> commandAgeOf(const ViewState &view);

} // namespace skyseal::ui
