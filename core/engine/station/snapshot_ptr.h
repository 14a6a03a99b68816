// A snapshot of the station as shared by threads and parts: immutable once it was taken.
#pragma once

#include <memory>

namespace skyseal::engine {

struct Snapshot;

using SnapshotPtr = std::shared_ptr<const Snapshot>;

} // namespace skyseal::engine
