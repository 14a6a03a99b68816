// Persistent state of a station other than recordings: the system ids that its peers have used, and, by the counter store, the
// counters of handshakes. Reports failures; nothing here stops a session. I/O thread.
#pragma once

#include "core/engine/common/sealed_systems.h"
#include "core/engine/common/storage_watch.h"
#include "core/engine/station/event.h"

#include <optional>

namespace skyseal::engine {

struct SecretFiles;

class StationStorage
{
public:
    /// Takes the state of the counter store, about once a second. Returns the event that is due.
    std::optional<CounterStorage> noteCounters(TimePoint now, const SecretFiles &secrets);
    /// Stores the system ids if they have changed. After a failure it tries again later, for `now` = kNever at once; the first
    /// failure is returned. The ids stay in force for this run in any case.
    std::optional<RecordingProblem> saveSystems(TimePoint now, SecretFiles &secrets, const SealedSystems &heard);

    /// Reason why counters are not stored; empty if they are.
    const Reason &countersProblem() const { return m_counters.problem(); }

private:
    StorageWatch m_counters;
    TimePoint m_saveSystemsAgain = TimePoint::min(); ///< after a failure
};

} // namespace skyseal::engine
