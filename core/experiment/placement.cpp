#include "core/experiment/placement.h"

#include <fstream>
#include <set>

#ifdef __linux__
#include <sched.h>
#endif

namespace skyseal::experiment {

namespace {

constexpr std::size_t kPrograms = 4;

#ifdef __linux__
std::vector<int> usableCores()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> out;
    if (::sched_getaffinity(0, sizeof set, &set) != 0)
        return out;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(core, &set))
            out.push_back(core);
    }
    return out;
}

void useCores(const std::vector<int> &cores)
{
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const int core : cores)
        CPU_SET(core, &set);
    ::sched_setaffinity(0, sizeof set, &set);
}
#else
std::vector<int> usableCores()
{
    return {};
}

void useCores(const std::vector<int> &) {}
#endif

/// One thread of each physical core first.
std::vector<int> distinctFirst(const std::vector<int> &cores)
{
    std::vector<int> first, others;
    std::set<std::string> seen;
    for (const int core : cores) {
        std::ifstream in("/sys/devices/system/cpu/cpu" + std::to_string(core) + "/topology/thread_siblings_list");
        std::string siblings;
        std::getline(in, siblings);
        (siblings.empty() || seen.insert(siblings).second ? first : others).push_back(core);
    }
    first.insert(first.end(), others.begin(), others.end());
    return first;
}

} // namespace

std::string Placement::text() const
{
    if (!station)
        return "left to the system: " + std::to_string(usable) + " usable cores are too few for one each";
    return "station's I/O thread on core " + std::to_string(*station) + "; agent on core " + std::to_string(*agent)
        + (simulator ? "; simulator on core " + std::to_string(*simulator) : "") + "; relay on core " + std::to_string(*relay);
}

Placement placementOn(const std::vector<int> &cores)
{
    Placement out;
    out.usable = static_cast<int>(cores.size());
    if (cores.size() <= kPrograms)
        return out;
    out.station = cores[0];
    out.agent = cores[1];
    out.simulator = cores[2];
    out.relay = cores[3];
    return out;
}

Placement placementHere()
{
    return placementOn(distinctFirst(usableCores()));
}

void runOnCore(int core)
{
#ifdef __linux__
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(core, &set);
    ::sched_setaffinity(0, sizeof set, &set);
#else
    static_cast<void>(core);
#endif
}

OnCore::OnCore(std::optional<int> core)
{
    if (!core)
        return;
    m_before = usableCores();
    runOnCore(*core);
}

OnCore::~OnCore()
{
    if (!m_before.empty())
        useCores(m_before);
}

} // namespace skyseal::experiment
