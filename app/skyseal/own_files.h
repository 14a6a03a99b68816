// Where this program keeps its identity, its known peers and its recordings, and the first run that makes them.
#pragma once

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/engine/station/station.h"

#include <QtCore/QString>

namespace skyseal::app {

/// The folder of the application's own data.
QString dataFolder();
QString defaultRecordFolder();

/// The key files of this user. Makes an identity and an empty list of peers where there is none yet. A key file that exists
/// but is damaged or open to others is left alone; the engine says so.
Result<engine::KeyPaths, InputError> ownKeys(RandomSource &random);

} // namespace skyseal::app
