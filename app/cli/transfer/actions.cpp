#include "app/cli/transfer/actions.h"

#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"

namespace skyseal::app {

int runAction(const QString &command, const QStringList &arguments, std::initializer_list<Action> actions, const char *usage)
{
    const QString program = QStringLiteral("skyseal-cli ") + command;
    const QString wanted = arguments.value(0);
    std::string names;
    std::size_t left = actions.size();
    for (const Action &action : actions) {
        if (wanted == QLatin1String(action.name) || (action.otherName && wanted == QLatin1String(action.otherName)))
            return action.run(program + QLatin1Char(' ') + wanted, arguments.mid(1));
        names += action.name;
        --left;
        names += left > 1 ? ", " : left == 1 ? " or " : "";
    }
    if (wanted == QLatin1String("--help") || wanted == QLatin1String("-h")) {
        printOwnText("Usage: " + program.toStdString() + " " + usage + " [options]\nEach command has --help.");
        return kDone;
    }
    complain(program, names + " is expected");
    return kUsage;
}

} // namespace skyseal::app
