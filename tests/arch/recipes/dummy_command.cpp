// Example of a command of skyseal-cli, for recipes_test. It is no part of the product.
#include "app/cli/commands.h"
#include "app/common/exit_status.h"

#include <cstdio>

namespace skyseal::app {

int runDummy(const QStringList &arguments)
{
    std::printf("%d\n", static_cast<int>(arguments.size()));
    return kDone;
}

} // namespace skyseal::app
