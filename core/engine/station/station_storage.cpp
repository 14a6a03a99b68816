#include "core/engine/station/station_storage.h"

#include "core/engine/common/secret_files.h"
#include "core/keys/counter_file.h"

namespace skyseal::engine {

std::optional<CounterStorage> StationStorage::noteCounters(TimePoint now, const SecretFiles &secrets)
{
    return m_counters.note(now, secrets.counters->problem());
}

std::optional<RecordingProblem> StationStorage::saveSystems(TimePoint now, SecretFiles &secrets, const SealedSystems &heard)
{
    if (secrets.paths.peers.empty() || heard == secrets.sealedSystems || now < m_saveSystemsAgain)
        return std::nullopt;
    const std::string file = sealedSystemsFile(secrets.paths);
    const auto written = writeSealedSystems(file, heard);
    const bool isFirst = m_saveSystemsAgain == TimePoint::min();
    m_saveSystemsAgain = written || now == kNever ? TimePoint::min() : now + keys::FileCounterStore::kRetryAfter;
    if (written) {
        secrets.sealedSystems = heard;
        return std::nullopt;
    }
    return isFirst ? std::optional(RecordingProblem{file, written.error().message}) : std::nullopt;
}

} // namespace skyseal::engine
