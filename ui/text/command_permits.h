// Whether the vehicle that the operator looks at can be told anything: where nothing would arrive, nothing is offered.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

/// Why no command can go to the view's vehicle, in a few words; empty when one can. A link that is only silent is no
/// reason: what we say may arrive even where nothing is heard.
QString whyNoCommands(const ViewState &view);
/// The same as a sentence: "Nothing can be sent: no vehicle"; empty for an empty reason.
QString nothingCanBeSent(const QString &reason);

} // namespace skyseal::ui
