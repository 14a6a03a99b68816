// What every program's exit status means; scripts rely on it.
#pragma once

namespace skyseal::app {

enum ExitStatus : int {
    kDone = 0,
    kNotReached = 1, ///< ran, but what was asked for did not happen
    kUsage = 2,
    kCannotOpen = 3 ///< a link or a file
};

} // namespace skyseal::app
