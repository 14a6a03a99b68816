// The command line options of skyseal.
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
    std::vector<link::LinkUrl> links; ///< empty: the link of the settings
    bool demo = false;
    QString screenshot;                  ///< file for a picture of the window; empty: none
    double screenshotAfter = 3;          ///< seconds
    std::string identityFile, peersFile; ///< empty: the files of the user
    PassphraseInput passphrase;          ///< none: a dialog asks
};

/// `arguments`: without the program's name. An exit status if the program is done: help or version was printed, or the usage is
/// wrong.
std::variant<WindowOptions, int> readOptions(const QStringList &arguments);

} // namespace skyseal::app
