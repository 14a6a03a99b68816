// A KML or GeoJSON file that is drawn over the map, as the settings keep it.
#pragma once

#include "ui/theme/overlay_colors.h"

#include <QtCore/QByteArray>
#include <QtCore/QList>
#include <QtCore/QString>

class QSettings;

namespace skyseal::ui {

struct OverlayFile
{
    QString path;
    bool visible = true;
    OverlayColor color = OverlayColor::Blue;
    QByteArray digest = {}; ///< SHA-256 of the content that the operator has accepted; empty: it could never be read

    bool operator==(const OverlayFile &) const = default;
};

inline constexpr int kMostOverlays = 32;

/// Invalid values get their defaults.
QList<OverlayFile> loadOverlays(const QSettings &store);
void storeOverlays(QSettings &store, const QList<OverlayFile> &files);

} // namespace skyseal::ui
