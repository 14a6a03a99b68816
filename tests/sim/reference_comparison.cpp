#include "tests/sim/reference_comparison.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace skyseal::sim {

namespace {

/// How far beyond the range of the reference a value may be; nothing for what is not listed.
const std::map<std::string, double> kTolerances{
    {"ATTITUDE.pitch", 0.01},
    {"ATTITUDE.roll", 0.01},
    {"ATTITUDE.yaw", 0.03},
    {"EKF_STATUS_REPORT.compass_variance", 0.1},
    {"EKF_STATUS_REPORT.pos_horiz_variance", 0.1},
    {"EKF_STATUS_REPORT.pos_vert_variance", 0.1},
    {"EKF_STATUS_REPORT.velocity_variance", 0.1},
    {"GLOBAL_POSITION_INT.alt", 400},          // mm
    {"GLOBAL_POSITION_INT.hdg", 150},          // centidegrees
    {"GLOBAL_POSITION_INT.lat", 100},          // 1e-7 degrees
    {"GLOBAL_POSITION_INT.lon", 100},          // 1e-7 degrees
    {"GLOBAL_POSITION_INT.relative_alt", 400}, // mm
    {"GLOBAL_POSITION_INT.vx", 5},             // cm/s
    {"GLOBAL_POSITION_INT.vy", 5},
    {"GLOBAL_POSITION_INT.vz", 5},
    {"GPS_RAW_INT.eph", 60},
    {"GPS_RAW_INT.epv", 100},
    {"GPS_RAW_INT.satellites_visible", 5},
    {"POWER_STATUS.Vcc", 100}, // mV
    {"RAW_IMU.xacc", 10},      // 1/1000 g
    {"RAW_IMU.yacc", 10},
    {"RAW_IMU.zacc", 10},
    {"RAW_IMU.xmag", 20}, // milligauss
    {"RAW_IMU.ymag", 20},
    {"RAW_IMU.zmag", 20},
    {"SCALED_PRESSURE.press_abs", 0.2}, // hPa
    {"SYS_STATUS.battery_remaining", 2},
    {"SYS_STATUS.voltage_battery", 100}, // mV
    {"VFR_HUD.airspeed", 0.2},
    {"VFR_HUD.alt", 0.4},
    {"VFR_HUD.climb", 0.1},
    {"VFR_HUD.groundspeed", 0.1},
    {"VFR_HUD.heading", 2},
};

/// The keys of both maps.
template<typename Map> std::set<std::string> keysOf(const Map &a, const Map &b)
{
    std::set<std::string> out;
    for (const Map *map : {&a, &b}) {
        for (const auto &entry : *map)
            out.insert(entry.first);
    }
    return out;
}

using Rates = std::map<std::string, double>;

void compareRates(const std::string &kind, const Rates &measured, const Rates &onFile, std::vector<std::string> &changes)
{
    const auto rateIn = [](const Rates &rates, const std::string &name) {
        const auto at = rates.find(name);
        return at == rates.end() ? 0 : at->second;
    };
    for (const std::string &name : keysOf(measured, onFile)) {
        const double now = rateIn(measured, name), known = rateIn(onFile, name);
        if (std::max(now, known) < 1 || isSameRate(now, known))
            continue;
        std::ostringstream line;
        line << kind << ' ' << name << ": " << known << " Hz on file, " << now << " measured";
        changes.push_back(line.str());
    }
}

void compareAnswers(const ReferenceFacts &measured, const ReferenceFacts &onFile, std::vector<std::string> &changes)
{
    const auto answerIn = [](const ReferenceFacts &facts, const std::string &step) {
        const auto at = facts.answers.find(step);
        return at == facts.answers.end() ? "no such step" : '[' + joined(at->second) + ']';
    };
    for (const std::string &step : keysOf(measured.answers, onFile.answers)) {
        const std::string now = answerIn(measured, step), known = answerIn(onFile, step);
        if (now != known)
            changes.push_back("answer " + step + ": " + known + " on file, " + now + " measured");
    }
}

void compareRanges(const ReferenceFacts &measured, const ReferenceFacts &onFile, std::vector<std::string> &changes)
{
    for (const std::string &field : keysOf(measured.ranges, onFile.ranges)) {
        const auto now = measured.ranges.find(field), known = onFile.ranges.find(field);
        if (now == measured.ranges.end() || known == onFile.ranges.end()) {
            changes.push_back("range " + field + ": only " + (now == measured.ranges.end() ? "on file" : "measured"));
        } else if (!isWithin(now->second, known->second, field)) {
            std::ostringstream line;
            line.precision(12);
            line << "range " << field << ": " << known->second.first << " to " << known->second.second << " on file, "
                 << now->second.first << " to " << now->second.second << " measured";
            changes.push_back(line.str());
        }
    }
}

} // namespace

std::string joined(const std::vector<std::string> &answers)
{
    std::string out;
    for (const std::string &answer : answers)
        out += (out.empty() ? "" : "; ") + answer;
    return out;
}

bool isSameRate(double rate, double reference)
{
    return std::abs(rate - reference) <= 0.1 * reference;
}

bool isWithin(ReferenceFacts::Range range, ReferenceFacts::Range reference, const std::string &field)
{
    const auto tolerance = kTolerances.find(field);
    const double beyond = tolerance == kTolerances.end() ? 0 : tolerance->second;
    return range.first >= reference.first - beyond && range.second <= reference.second + beyond;
}

std::vector<std::string> changesOf(const ReferenceFacts &measured, const ReferenceFacts &onFile)
{
    std::vector<std::string> changes;
    Rates silent = measured.silentRates;
    silent.erase("PARAM_VALUE"); // of parameters that are set at its start; how many depends on when the station connects
    compareRates("silent", silent, onFile.silentRates, changes);
    compareRates("rate", measured.rates, onFile.rates, changes);
    compareAnswers(measured, onFile, changes);
    compareRanges(measured, onFile, changes);
    return changes;
}

} // namespace skyseal::sim
