// A QR code in a terminal, by libqrencode where the build has it.
#pragma once

#include <string>

namespace skyseal::app {

/// False in builds without libqrencode.
bool canShowQr();
/// Lines of half blocks, two rows of modules each, with the quiet zone around; empty when it cannot be made.
std::string qrText(const std::string &content);

} // namespace skyseal::app
