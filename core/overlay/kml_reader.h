// KML 2.2: the points, lines and polygons of its placemarks, with their names. https://www.ogc.org/standard/kml/
// Styles, heights, times and links to other files are ignored.
#pragma once

#include "core/base/result.h"
#include "core/overlay/overlay.h"

#include <QtCore/QByteArray>

namespace skyseal::overlay {

/// Reads the content of a .kml file, from any source. The error names the line, but no file.
Result<Overlay, InputError> readKml(const QByteArray &content);

} // namespace skyseal::overlay
