// ArduPilot's packed parameter file, @PARAM/param.pck: all parameters by MAVLink FTP, or some of them to be written. The
// format is that of AP_Filesystem_Param.cpp there ("packed format"): a header of three 16-bit numbers, then for each parameter
// its type and flags, the length of the prefix that its name shares with the previous one, the rest of the name, and the value,
// with its default if there is one. Zeros before a parameter are padding.
#pragma once

#include "core/base/bytes.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::mavlink {

/// The first number of a file, without and with default values.
inline constexpr std::uint16_t kPackedMagic = 0x671b, kPackedMagicWithDefaults = 0x671c;
/// Types in a file: those of ArduPilot's AP_Param (ap_var_type), not of MAVLink.
enum PackedType : std::uint8_t { kPackedInt8 = 1, kPackedInt16 = 2, kPackedInt32 = 3, kPackedFloat = 4 };

struct PackedParameter
{
    std::string name;      ///< 1 to 16 characters, as they are in the file
    std::uint8_t type = 0; ///< MAV_PARAM_TYPE_INT8, _INT16, _INT32 or _REAL32
    double value = 0;
};

struct PackedParameters
{
    bool hasDefaults = false;                ///< the file contains default values, which are skipped
    std::uint16_t total = 0;                 ///< parameters of the vehicle; in a file to be written, its length
    std::vector<PackedParameter> parameters; ///< in the order of the vehicle's list
};

/// Reads a whole file. Returns nullopt if it is damaged: truncated, longer than its header says, or with an invalid name or
/// type.
std::optional<PackedParameters> parsePackedParameters(ByteView file);

} // namespace skyseal::mavlink
