// Sentences about what happens, for people at a terminal. English only; the window has its own words, translated.
#pragma once

#include "core/engine/station/event.h"

#include <map>
#include <string>

namespace skyseal::app {

/// The suite's name; research suites carry the word "insecure" wherever it stands.
std::string suiteText(crypto::SuiteId suite);
/// What became of a link; empty for states that people need not hear of.
std::string linkText(const engine::LinkSnapshot &link);
/// A sentence about a event; empty for those that people need not hear of.
std::string sentence(const engine::Event &event, const std::map<channel::SessionId, std::string> &peers);

} // namespace skyseal::app
