// Where and with what something was measured, as a publication has to state it.
#pragma once

#include "core/experiment/results.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::experiment {

/// Machine, processor and its features, system, load, libraries, compiler and build of this program. The caller adds what
/// only it knows: version, command line, time, seed.
Setting machineSetting();

/// What makes figures of a machine doubtful that is this busy as the measurement begins; empty up to half of its cores.
std::string busyWarning(double load, long cores);
/// The same of this machine now.
std::string busyWarning();

/// What makes figures of a build doubtful that was compiled with these flags and no -O2 or -O3; empty for one that was.
std::string buildWarning(std::string_view flags);

/// What makes the figures of a setting doubtful, in sentences without a full stop.
std::vector<std::string> warningsOf(const Setting &setting);

/// Whether OpenSSL uses AES instructions in this process, by what it says itself; nothing where it does not say.
std::optional<bool> opensslUsesAes();
/// By the text of OPENSSL_CPU_INFO.
std::optional<bool> opensslUsesAes(std::string_view cpuInfo);

} // namespace skyseal::experiment
