#include "core/vehicle/request.h"

template struct skyseal::CompiledOnce<skyseal::vehicle::RequestVariant>;
