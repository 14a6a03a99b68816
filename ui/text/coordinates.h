// Places as people read and exchange them.
#pragma once

#include <QtCore/QString>

namespace skyseal::ui {

/// UTM stands for the polar grid (UPS) too, north of 84° and south of 80°.
enum class CoordinateFormat : int { Decimal, DegreesMinutesSeconds, Utm, Mgrs };

enum class Compass : int { North, East, South, West };

/// The letter of a direction in the language of the window: "E", or "O" in German.
QString compassLetter(Compass direction);

/// A place in degrees (WGS84) for the window: "−35.363261 149.165230" (about 0.1 m), "35°21'47.7" S 149°09'54.8" E",
/// "55 south 696719 mE 6084520 mN" (to the nearest metre), or "55H FA 96719 84519" (the square metre that has the place).
/// A dash if there is no such place.
QString coordinatesText(double latitude, double longitude, CoordinateFormat format);
/// The same for the clipboard, as other programs read it: "-35.363261, 149.165230", "55s 696719 6084520" or "55HFA9671984519".
QString coordinatesToCopy(double latitude, double longitude, CoordinateFormat format);
/// A text as wide as coordinatesText() can be, with figures of equal width.
QString widestCoordinates(CoordinateFormat format);

} // namespace skyseal::ui
