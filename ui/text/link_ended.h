// Texts about a vehicle whose sealed session has ended, and about agents without a session, for the lock and the panels.
#pragma once

#include "core/engine/station/unknown_agent.h"
#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

struct LinkEnded
{
    QString title;  ///< a few words
    QString advice; ///< reason and next step
    bool revoked = false;
};

/// Returns nothing if the session of the view's vehicle is up, for a plain vehicle and without a vehicle.
std::optional<LinkEnded> linkEndedOf(const ViewState &view);

/// Returns the agent of the view's vehicle (or any, without a vehicle) that announces itself but does not answer; null if there
/// is none.
const engine::UnansweringAgent *unansweringOf(const ViewState &view);

/// Returns an agent with an unknown key if nothing else is connected; null otherwise.
const engine::UnknownAgent *unknownAgentOf(const ViewState &view);

} // namespace skyseal::ui
