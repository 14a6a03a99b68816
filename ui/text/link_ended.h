// What is true of a vehicle that was heard over a sealed session which is not there any more: words for the lock and for the
// panel.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

struct LinkEnded
{
    QString title;  ///< a few words
    QString advice; ///< why, and what comes next
    bool revoked = false;
};

/// Nothing while the session of the view's vehicle is up, for a vehicle in clear and without a vehicle.
std::optional<LinkEnded> linkEndedOf(const ViewState &view);

/// The agent of the view's vehicle (or any, where there is none) that is there and does not answer; null when none is so.
const engine::UnansweringAgent *unansweringOf(const ViewState &view);

/// An agent whose key is not known here, where that is all there is; null otherwise.
const engine::UnknownAgent *unknownAgentOf(const ViewState &view);

} // namespace skyseal::ui
