// The setting of a measurement as a publication must state it: machine, system, libraries, compiler and build.
#pragma once

#include "core/experiment/results.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::experiment {

/// Machine, processor and its features, system, load, libraries, compiler and build of this program. The caller adds
/// version, command line, time and seed.
Setting machineSetting();

/// Warning if the machine is busy when the measurement begins; empty up to a load of half the cores.
Reason busyWarning(double load, long cores);

/// Warning if a build with these flags is not optimised by -O2 or -O3; empty otherwise.
Reason buildWarning(std::string_view flags);

/// The warnings of a setting, sentences without a full stop. Those of machineSetting() can be translated; what another version
/// wrote into a file stays as it is.
std::vector<Reason> warningsOf(const Setting &setting);

/// True if OpenSSL uses AES instructions in this process; nullopt if it does not report that.
std::optional<bool> opensslUsesAes();
/// The same for the text of OPENSSL_CPU_INFO.
std::optional<bool> opensslUsesAes(std::string_view cpuInfo);

} // namespace skyseal::experiment
