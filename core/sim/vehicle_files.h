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

    FileResult<std::vector<FileEntry>> list(std::string_view directory) const;
    /// A copy of a file as it is now.
    FileResult<Bytes> read(std::string_view path) const;
    FileResult<void> create(std::string_view path, bool truncate);
    FileResult<void> write(std::string_view path, std::uint32_t offset, ByteView bytes);
    FileResult<void> truncate(std::string_view path, std::uint32_t size);
    FileResult<void> remove(std::string_view path);
    FileResult<void> makeDirectory(std::string_view path);
    FileResult<void> removeDirectory(std::string_view path);
    FileResult<void> rename(std::string_view from, std::string_view to);

    /// Whether a path is the packed parameter file, which is uploaded as a whole.
    static bool isParameterFile(std::string_view path);
    FileResult<void> storeParameters(ByteView file);

private:
    /// A normalised path that may be changed: on the card, and not what the vehicle itself keeps there.
    static FileResult<std::string> changeable(std::string_view path);
    std::optional<std::size_t> findLog(const std::string &path) const;
    std::string newestLog() const;

    FileStore &m_card;
    FlightLogs &m_logs;
    Autopilot &m_autopilot;
};

} // namespace skyseal::sim
