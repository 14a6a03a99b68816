// The command line of the window.
#pragma once

#include "app/common/passphrase_input.h"
#include "core/link/link_url.h"

#include <QtCore/QStringList>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace skyseal::app {

struct WindowOptions
{
    std::vector<link::LinkUrl> links; ///< empty = the one of the settings
    bool demo = false;
    QString screenshot;                  ///< file to save a picture of the window to; empty = none
    double screenshotAfter = 3;          ///< seconds
    std::string identityFile, peersFile; ///< empty = the user's own
    PassphraseInput passphrase;          ///< none given = a dialog asks
};

/// `arguments`: without the program's name. An exit status if the program is done: help or version was printed, or the usage is
/// wrong.
std::variant<WindowOptions, int> readOptions(const QStringList &arguments);

} // namespace skyseal::app
