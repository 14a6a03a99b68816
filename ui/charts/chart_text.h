// What a chart says about a moment: the values of its lines there, and what happened nearby.
#pragma once

#include "ui/charts/chart.h"

namespace skyseal::ui {

/// "−32.5 s", "now", "12 s in use".
QString chartTimeText(double x, ChartTime time, int decimals);

/// The time, then a line for each suite and quantity that has a value near `x`; marks nearer than `reach` seconds at the
/// end.
QStringList chartTextAt(const ChartContent &content, double x, double reach, int decimals);

} // namespace skyseal::ui
