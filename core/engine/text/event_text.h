// One sentence for each event of the station, the same in the window and on the command line. Translated through
// QCoreApplication; English without a translator. Any thread.
#pragma once

#include "core/engine/station/event.h"
#include "core/engine/text/common_event_text.h"

namespace skyseal::engine {

/// `names` must have noted the event.
EventText eventText(const Event &event, const PeerNames &names);
/// For what shows the state: the sentence of the event that reports it.
QString unansweringText(const UnansweringAgent &agent);
QString countersNotStoredText(const Reason &problem);
/// "accepted", "denied: …", "no answer to 5 attempts"
QString commandOutcomeText(const vehicle::CommandResult &result);

} // namespace skyseal::engine
