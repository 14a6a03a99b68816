#include "core/vehicle/flight_modes.h"

#include "core/vehicle/result_text.h"

#include <charconv>
#include <span>

namespace skyseal::vehicle {

namespace {

struct Mode
{
    std::uint32_t number;
    std::string_view name;
};

constexpr Mode kCopterModes[] = {
    {0, "STABILIZE"},  {1, "ACRO"},      {2, "ALT_HOLD"}, {3, "AUTO"},    {4, "GUIDED"},      {5, "LOITER"},
    {6, "RTL"},        {7, "CIRCLE"},    {9, "LAND"},     {11, "DRIFT"},  {13, "SPORT"},      {14, "FLIP"},
    {15, "AUTOTUNE"},  {16, "POSHOLD"},  {17, "BRAKE"},   {18, "THROW"},  {19, "AVOID_ADSB"}, {20, "GUIDED_NOGPS"},
    {21, "SMART_RTL"}, {22, "FLOWHOLD"}, {23, "FOLLOW"},  {24, "ZIGZAG"}, {25, "SYSTEMID"},   {26, "AUTOROTATE"},
    {27, "AUTO_RTL"},  {28, "TURTLE"}};

constexpr Mode kPlaneModes[] = {
    {0, "MANUAL"},        {1, "CIRCLE"},      {2, "STABILIZE"}, {3, "TRAINING"},    {4, "ACRO"},
    {5, "FBWA"},          {6, "FBWB"},        {7, "CRUISE"},    {8, "AUTOTUNE"},    {10, "AUTO"},
    {11, "RTL"},          {12, "LOITER"},     {13, "TAKEOFF"},  {14, "AVOID_ADSB"}, {15, "GUIDED"},
    {16, "INITIALISING"}, {17, "QSTABILIZE"}, {18, "QHOVER"},   {19, "QLOITER"},    {20, "QLAND"},
    {21, "QRTL"},         {22, "QAUTOTUNE"},  {23, "QACRO"},    {24, "THERMAL"},    {25, "LOITERALTQLAND"},
    {26, "AUTOLAND"}};

constexpr Mode kRoverModes[] = {{0, "MANUAL"}, {1, "ACRO"},       {3, "STEERING"}, {4, "HOLD"},         {5, "LOITER"},
                                {6, "FOLLOW"}, {7, "SIMPLE"},     {8, "DOCK"},     {9, "CIRCLE"},       {10, "AUTO"},
                                {11, "RTL"},   {12, "SMART_RTL"}, {15, "GUIDED"},  {16, "INITIALISING"}};

constexpr Mode kSubmarineModes[] = {{0, "STABILIZE"}, {1, "ACRO"},         {2, "ALT_HOLD"}, {3, "AUTO"},
                                    {4, "GUIDED"},    {7, "CIRCLE"},       {9, "SURFACE"},  {16, "POSHOLD"},
                                    {19, "MANUAL"},   {20, "MOTORDETECT"}, {21, "SURFTRAK"}};

constexpr Mode kTrackerModes[] = {{0, "MANUAL"}, {1, "STOP"},  {2, "SCAN"},         {3, "SERVO_TEST"},
                                  {4, "GUIDED"}, {10, "AUTO"}, {16, "INITIALISING"}};

/// PX4 packs the main mode into bits 16..23 and the sub mode into bits 24..31.
constexpr std::uint32_t px4(std::uint32_t mainMode, std::uint32_t subMode = 0)
{
    return mainMode << 16 | subMode << 24;
}

constexpr Mode kPx4Modes[] = {
    {px4(1), "MANUAL"},     {px4(2), "ALTCTL"},      {px4(3), "POSCTL"},      {px4(4, 1), "READY"},
    {px4(4, 2), "TAKEOFF"}, {px4(4, 3), "LOITER"},   {px4(4, 4), "MISSION"},  {px4(4, 5), "RTL"},
    {px4(4, 6), "LAND"},    {px4(4, 8), "FOLLOWME"}, {px4(4, 9), "PRECLAND"}, {px4(4, 10), "VTOL_TAKEOFF"},
    {px4(5), "ACRO"},       {px4(6), "OFFBOARD"},    {px4(7), "STABILIZED"},  {px4(8), "RATTITUDE"}};

std::span<const Mode> modesOf(VehicleKind kind)
{
    if (kind.isPx4())
        return kPx4Modes;
    if (!kind.isArduPilot())
        return {};
    if (kind.isCopter())
        return kCopterModes;
    if (kind.isPlane())
        return kPlaneModes;
    if (kind.isRover())
        return kRoverModes;
    if (kind.isSubmarine())
        return kSubmarineModes;
    if (kind.type == 5) // MAV_TYPE_ANTENNA_TRACKER
        return kTrackerModes;
    return {};
}

constexpr std::uint8_t kCustomModeEnabled = 1; // MAV_MODE_FLAG_CUSTOM_MODE_ENABLED and its neighbours
constexpr std::uint8_t kAutoEnabled = 4, kGuidedEnabled = 8, kStabilizeEnabled = 16, kManualInputEnabled = 64;

} // namespace

bool VehicleKind::isCopter() const
{
    switch (type) {
    case 2:
    case 3:
    case 4:
    case 13:
    case 14:
    case 15:
    case 29:
    case 35:
    case 43: return true; // quad, coaxial, helicopter, hexa, octo, tri, dodeca, deca, any other multirotor
    default: return false;
    }
}

bool VehicleKind::isPlane() const
{
    return type == 1 || (type >= 19 && type <= 25); // fixed wing; the kinds of vertical take-off
}

bool VehicleKind::isRover() const
{
    return type == 10 || type == 11;
}

bool VehicleKind::isSubmarine() const
{
    return type == 12;
}

std::string modeName(VehicleKind kind, std::uint8_t baseMode, std::uint32_t customMode)
{
    if (baseMode & kCustomModeEnabled) {
        for (const Mode &mode : modesOf(kind)) {
            if (mode.number == customMode)
                return std::string(mode.name);
        }
        return "MODE(" + std::to_string(customMode) + ")";
    }
    if (baseMode & kAutoEnabled)
        return "AUTO";
    if (baseMode & kGuidedEnabled)
        return "GUIDED";
    if (baseMode & kStabilizeEnabled)
        return "STABILIZE";
    if (baseMode & kManualInputEnabled)
        return "MANUAL";
    return "PREFLIGHT";
}

std::optional<std::uint32_t> modeNumber(VehicleKind kind, std::string_view name)
{
    for (const Mode &mode : modesOf(kind)) {
        if (sameWord(mode.name, name))
            return mode.number;
    }
    if (name.size() > 6 && sameWord(name.substr(0, 5), "MODE(") && name.back() == ')') {
        std::uint32_t number = 0;
        const char *end = name.data() + name.size() - 1;
        const auto [stop, error] = std::from_chars(name.data() + 5, end, number);
        if (error == std::errc() && stop == end)
            return number;
    }
    return std::nullopt;
}

std::vector<std::string> modeNames(VehicleKind kind)
{
    std::vector<std::string> out;
    for (const Mode &mode : modesOf(kind))
        out.emplace_back(mode.name);
    return out;
}

} // namespace skyseal::vehicle
