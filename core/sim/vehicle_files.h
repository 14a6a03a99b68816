// The files of a vehicle as MAVLink FTP shows them: a memory card, the flight logs under /APM/LOGS, and the parameters as
// @PARAM/param.pck.
#pragma once

#include "core/sim/autopilot.h"
#include "core/sim/file_store.h"
#include "core/sim/flight_logs.h"

namespace skyseal::sim {

class VehicleFiles
{
public:
    VehicleFiles(FileStore &card, FlightLogs &logs, Autopilot &autopilot);

    StoreResult<std::vector<FileEntry>> list(std::string_view directory) const;
    /// A copy of a file as it is now.
    StoreResult<Bytes> read(std::string_view path) const;
    StoreResult<void> create(std::string_view path, bool truncate);
    StoreResult<void> write(std::string_view path, std::uint32_t offset, ByteView bytes);
    StoreResult<void> truncate(std::string_view path, std::uint32_t size);
    StoreResult<void> remove(std::string_view path);
    StoreResult<void> makeDirectory(std::string_view path);
    StoreResult<void> removeDirectory(std::string_view path);
    StoreResult<void> rename(std::string_view from, std::string_view to);

    /// Whether a path is the packed parameter file, which is uploaded as a whole.
    static bool isParameterFile(std::string_view path);
    StoreResult<void> storeParameters(ByteView file);

private:
    /// A normalised path that may be changed: on the card, and not what the vehicle itself keeps there.
    static StoreResult<std::string> changeable(std::string_view path);
    std::optional<std::size_t> findLog(const std::string &path) const;
    std::string newestLog() const;

    FileStore &m_card;
    FlightLogs &m_logs;
    Autopilot &m_autopilot;
};

} // namespace skyseal::sim
