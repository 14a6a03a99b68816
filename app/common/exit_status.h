// The exit statuses of all programs; scripts rely on them.
#pragma once

namespace skyseal::app {

enum ExitStatus : int {
    kDone = 0,
    kNotReached = 1, ///< ran, but the requested result was not reached
    kUsage = 2,
    kCannotOpen = 3 ///< a link or file could not be opened, or a result could not be written
};

} // namespace skyseal::app
