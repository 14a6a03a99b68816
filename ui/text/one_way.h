// What is true of a vehicle that is only heard: of a recording, and of a stream that is never sent to. Text for the lock,
// the panel and all that would send something.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

struct OneWay
{
    QString title; ///< a few words
    QString advice;
    QString whyNot; ///< why no command goes there, in a few words
    bool recorded = false;
};

/// Nothing for a vehicle that something can be sent to, as far as its link is concerned, and without a vehicle.
std::optional<OneWay> oneWayOf(const ViewState &view);

} // namespace skyseal::ui
