// Words for what is noted beside a recording, for the list of recordings and the bar of a replay.
#pragma once

#include "core/log/log_index.h"

#include <QtCore/QString>

namespace skyseal::ui {

/// "2 unreadable lines about ciphers"; empty if there are none.
QString unreadableEventsText(const tlog::LogIndex &index);

} // namespace skyseal::ui
