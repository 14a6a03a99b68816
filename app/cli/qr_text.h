// A QR code for a terminal, by libqrencode if the build has it.
#pragma once

#include <string>

namespace skyseal::app {

/// False in builds without libqrencode.
bool canShowQr();
/// Lines of half blocks, two rows of modules each, with the quiet zone; empty on failure.
std::string qrText(const std::string &content);

} // namespace skyseal::app
