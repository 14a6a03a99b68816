// Text of others (names of peers, texts of vehicles, file names, errors of links) that is shown to people. Control characters
// steer a terminal and forge lines; format characters, such as those that change the direction of the text or have no width,
// let a name look like another one.
#pragma once

#include <string>
#include <string_view>

namespace skyseal {

/// Whether the code point is a control character, a separator of lines, or is invisible: the general categories Cc, Cf, Zl and
/// Zp and the property Default_Ignorable_Code_Point of Unicode 15.
bool isUnprintable(char32_t character);

/// Whether the text is valid UTF-8 without unprintable characters.
bool isPrintable(std::string_view text);

/// The text with `replacement` for each unprintable character and each invalid part of UTF-8. Leaves the output of JsonWriter
/// as it is, which escapes them.
std::string printable(std::string_view text, char replacement = '?');

} // namespace skyseal
