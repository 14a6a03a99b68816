// Everything that can be requested of a vehicle. Windows, scripts and the engine pass a Request on unchanged; only the client
// of its micro-protocol looks inside. The way back is Event (event.h).
#pragma once

#include "core/base/compiled_once.h"
#include "core/vehicle/mission.h"
#include "core/vehicle/onboard_log.h"
#include "core/vehicle/parameter.h"
#include "core/vehicle/remote_file.h"
#include "core/vehicle/request_id.h"
#include "core/vehicle/vehicle_command.h"

#include <variant>

namespace skyseal::vehicle {

using RequestVariant =
    std::variant<VehicleCommand, ReadParameters, ReadParameter, WriteParameter, ReadMission, WriteMission, ClearMission,
                 ListFolder, ReadFile, WriteFile, RemoveFile, ListLogs, ReadLog, EraseLogs, CancelTransfer>;
using Request = CompiledOnce<RequestVariant>;

} // namespace skyseal::vehicle

extern template struct skyseal::CompiledOnce<skyseal::vehicle::RequestVariant>;
