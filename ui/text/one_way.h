// Texts about a vehicle that nothing can be sent to: a replayed log or a listen-only link. For the lock, the panels and
// disabled commands.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

struct OneWay
{
    QString title; ///< a few words
    QString advice;
    QString disabledReason; ///< reason why commands cannot be sent, in a few words
    bool recorded = false;
};

/// Returns nothing if the link of the vehicle can send, and without a vehicle.
std::optional<OneWay> oneWayOf(const ViewState &view);

} // namespace skyseal::ui
