// Reads a file with shapes by its suffix.
#pragma once

#include "core/base/result.h"
#include "core/overlay/overlay.h"

#include <QtCore/QByteArray>

namespace skyseal::overlay {

struct ReadOverlay
{
    Overlay overlay;
    QByteArray digest; ///< SHA-256 of the file
};

/// Reads a .kml, .geojson or .json file of at most 64 MB. Waits for the disk. The error names the file, the line or the path in
/// it as far as known, and what is wrong.
Result<ReadOverlay, InputError> readOverlay(const QString &path);

} // namespace skyseal::overlay
