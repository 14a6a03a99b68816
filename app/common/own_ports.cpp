#include "app/common/own_ports.h"

namespace skyseal::app {

void refuseOwnPorts(Options &options, const std::string &program, const std::vector<OptionLink> &links)
{
    for (const OptionLink &one : links) {
        for (const OptionLink &other : links) {
            if (one.url.reaches(other.url) || (&other < &one && one.url.sharesPort(other.url)))
                options.fail(std::string("--") + one.option + " '" + one.url.toText() + "': " + program
                             + " itself listens there, with --" + other.option + " " + other.url.toText());
        }
    }
}

} // namespace skyseal::app
