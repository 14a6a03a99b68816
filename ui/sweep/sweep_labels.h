// Texts for the parts of a sweep.
#pragma once

#include "core/experiment/contrast.h"

#include <QtCore/QString>

#include <string>
#include <string_view>

namespace skyseal::ui {

/// Figures as reports have them, "1,234.5", with the separators of the window's language.
QString localNumber(const std::string &figures);
/// "AES-256-CTR, inline"; "ChaCha20-Poly1305, sealed (A/A)"; "plain, not sealed".
QString armText(const experiment::SweepArm &arm);
QString framingText(const experiment::SweepArm &arm);
QString loadText(experiment::Load load);
/// "clean link"; "57,600 baud, 5 % loss, 20 ms delay".
QString linkText(const experiment::Condition &link);
/// "natural load"; with impaired links in the sweep, "57,600 baud, 20 ms delay · natural load".
QString placeText(const experiment::Plan &plan, std::size_t condition, std::size_t load);
/// "about 2 min 20 s", "about 12 s".
QString aboutTime(double seconds);
/// "1.08 (1.05 to 1.11)", with the 95 % interval where there is one.
QString ratioText(const experiment::Contrast &ratio);
/// "Ratios to plain MAVLink", or to the first suite where that was not measured.
QString ratiosText(const experiment::Plan &plan);
/// "CPU time per frame, station".
QString metricTitle(experiment::Metric metric);
/// How it is measured.
QString metricDescription(experiment::Metric metric);
/// With its unit: "Packets transmitted", "CPU time per frame, station, ns".
QString metricText(experiment::Metric metric);
/// The same for values in another unit, such as "µs".
QString metricText(experiment::Metric metric, std::string_view unit);
/// Shown in place of the values of an arm that does not exist.
QString notInFramingText();

} // namespace skyseal::ui
