// The commit that this program was built from; written at each build by cmake/BuildCommit.cmake.
#pragma once

namespace skyseal::experiment {

/// "1fd5920", with the suffix "-changed" if files differ from that commit; "unknown" outside a repository.
extern const char *const kBuildCommit;

} // namespace skyseal::experiment
