// Of which state of the source this program was built; written at each build by cmake/BuildCommit.cmake.
#pragma once

namespace skyseal::experiment {

/// "1fd5920", with "-changed" behind it where files differed from that commit; "unknown" outside of a repository.
extern const char *const kBuildCommit;

} // namespace skyseal::experiment
