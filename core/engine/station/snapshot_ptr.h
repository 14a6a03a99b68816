// A snapshot of the station as threads and parts share it: one that was taken does not change.
#pragma once

#include <memory>

namespace skyseal::engine {

struct Snapshot;

using SnapshotPtr = std::shared_ptr<const Snapshot>;

} // namespace skyseal::engine
