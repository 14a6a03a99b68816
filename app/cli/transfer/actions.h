// Commands that consist of several, such as "skyseal-cli param get": selection by the first argument.
#pragma once

#include <QtCore/QStringList>

#include <functional>
#include <initializer_list>

namespace skyseal::app {

struct Action
{
    const char *name;
    /// Gets the whole name, for messages, and the arguments that follow; returns the exit status.
    std::function<int(const QString &name, const QStringList &arguments)> run;
    const char *otherName = nullptr; ///< understood, and not shown
};

/// Runs the action that the first argument names; returns its exit status. `command`: "param". `usage`: the actions with their
/// arguments, for --help.
int runAction(const QString &command, const QStringList &arguments, std::initializer_list<Action> actions, const char *usage);

} // namespace skyseal::app
