// A double of the system's notification of changed files, for the whole test program.
#pragma once

namespace skyseal::test {

enum class Inotify {
    Works,
    UsedUp, ///< no watches are left
    Silent  ///< as on a network file system: watches can be added, and nothing is ever notified
};
extern Inotify inotifyIs;

} // namespace skyseal::test
