// Configuration files of the programs: one option a line, NAME = VALUE, as on the command line without the dashes; a flag has
// the value yes or no. Comments (lines that begin with #) and empty lines are ignored.
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace skyseal::app {

struct ConfigLine
{
    std::size_t number = 0; ///< of the line, from 1
    std::string name, value;
};

/// `source` names the text in errors. Safe for any bytes.
Result<std::vector<ConfigLine>, InputError> parseConfig(std::string_view text, const std::string &source);
/// Fails if other users can change the file: it decides who may command.
Result<std::vector<ConfigLine>, InputError> readConfig(const std::string &path);

} // namespace skyseal::app
