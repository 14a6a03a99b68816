// How tiles are requested and kept, for all sources.
#pragma once

#include <QtCore/QString>

namespace skyseal::ui {

struct TileConfig
{
    QString userAgent;   ///< "Skyseal/VERSION"
    QString cacheFolder; ///< of what servers sent; empty: nothing is kept on the disk
    qint64 cacheBytes = 200'000'000;
    int pauseMs = 2000; ///< after a failed request; doubled for each further one
};

} // namespace skyseal::ui
