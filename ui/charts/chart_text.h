// The text of the cursor: the values of the lines at one time, and the events near it.
#pragma once

#include "ui/charts/chart.h"

namespace skyseal::ui {

/// "−32.5 s", "now", "12 s in use".
QString chartTimeText(double x, ChartTime time, int decimals);

/// Returns the time, a line for each suite and quantity with a value near `x`, then the marks within `reach` seconds.
QStringList chartTextAt(const ChartContent &content, double x, double reach, int decimals);

} // namespace skyseal::ui
