# skyseal_hardening: the compiler and linker options that make memory errors harder to exploit, as Debian builds its own network
# programs. All libraries, programs and benchmarks use it; tests/packaging/check_hardening.py reads their effect from the built
# files. Sanitizers replace these checks by their own and do not combine with them.
include(CheckCXXCompilerFlag)

add_library(skyseal_hardening INTERFACE)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
target_link_options(skyseal_hardening INTERFACE $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-pie>)
if(SKYSEAL_SANITIZE)
  return()
endif()

# Level 3, in what is installed, also checks copies whose destination has a size known at run time only. Debug builds have
# none: it needs optimization.
target_compile_options(skyseal_hardening INTERFACE
  -fstack-protector-strong -fstack-clash-protection
  $<$<CONFIG:Release,MinSizeRel>:-D_FORTIFY_SOURCE=3> $<$<CONFIG:RelWithDebInfo>:-D_FORTIFY_SOURCE=2>)
# Indirect calls reach only marked targets, and returns their callers, where the processor enforces it: x86 (CET), ARM (BTI, PAC).
set(CMAKE_REQUIRED_FLAGS -Werror) # clang only warns of options that the processor does not have
foreach(option -fcf-protection -mbranch-protection=standard)
  string(MAKE_C_IDENTIFIER "SKYSEAL_HAS${option}" known)
  check_cxx_compiler_flag(${option} ${known})
  if(${known})
    target_compile_options(skyseal_hardening INTERFACE ${option})
  endif()
endforeach()
unset(CMAKE_REQUIRED_FLAGS)
# Read-only relocations, all symbols bound at start, no executable stack.
target_link_options(skyseal_hardening INTERFACE -Wl,-z,relro,-z,now,-z,noexecstack)
