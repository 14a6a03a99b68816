// The default files of this program (identity, known peers, recordings), and their creation at the first run.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/engine/station/station.h"

#include <QtCore/QString>

namespace skyseal::app {

/// The folder of the application's data.
QString dataFolder();
QString defaultRecordFolder();
/// Of the indexes of recordings, see engine/replay/index_cache.h.
QString indexCacheFile();

/// The key files of this user. Creates an identity and an empty list of peers if they do not exist. A key file that is damaged
/// or accessible by others is not changed; the engine reports it.
Result<engine::KeyPaths, InputError> ownKeys(RandomSource &random);

} // namespace skyseal::app
