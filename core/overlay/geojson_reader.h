// GeoJSON: features, geometries and collections of them, with the names among their properties.
// https://www.rfc-editor.org/rfc/rfc7946
#pragma once

#include "core/base/result.h"
#include "core/overlay/overlay.h"

#include <QtCore/QByteArray>

namespace skyseal::overlay {

/// Reads the content of a .geojson file, from any source. The error names the line and, if it is JSON, the path of the
/// member, like "features[3].geometry.coordinates[12]"; it names no file.
Result<Overlay, InputError> readGeoJson(const QByteArray &content);

} // namespace skyseal::overlay
