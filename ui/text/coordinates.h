// Places as people read and exchange them.
#pragma once

#include <QtCore/QString>

namespace skyseal::ui {

enum class CoordinateFormat : int { Decimal, DegreesMinutesSeconds };

/// A place in degrees (WGS84) for the window: "−35.363261 149.165230" (about 0.1 m), or "35°21'47.7" S 149°09'54.8" E".
QString coordinatesText(double latitude, double longitude, CoordinateFormat format);
/// The same for the clipboard, as other programs read it: "-35.363261, 149.165230".
QString coordinatesToCopy(double latitude, double longitude, CoordinateFormat format);

} // namespace skyseal::ui
