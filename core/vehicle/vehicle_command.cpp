#include "core/vehicle/vehicle_command.h"

template struct skyseal::CompiledOnce<skyseal::vehicle::VehicleCommandVariant>;
