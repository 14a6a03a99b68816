# The options that all targets share, and the functions that declare libraries, programs and tests.

add_library(skyseal_options INTERFACE)
target_compile_options(skyseal_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast -Wcast-qual
  $<$<BOOL:${SKYSEAL_WERROR}>:-Werror>)
# g++ 12 warns of overlapping copies inside operator+(const char *, std::string &&) (GCC bug 105329), and of what other
# alternatives of a std::variant or std::optional hold when one is moved (GCC bug 80635); differently at each -O.
target_compile_options(skyseal_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-stringop-overflow;-Wno-array-bounds>")
# Optimised at link time, GCC compiles there.
target_link_options(skyseal_options INTERFACE "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-stringop-overflow>")
target_include_directories(skyseal_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_definitions(skyseal_options INTERFACE
  QT_NO_CAST_FROM_ASCII QT_NO_FOREACH QT_NO_KEYWORDS $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>
  $<$<NOT:$<BOOL:${SKYSEAL_RESEARCH}>>:SKYSEAL_WITHOUT_RESEARCH>)

include(SkysealHardening)

# moc reads every header that a file includes, over a second for a test, although it needs none here: what it generates code for
# is in the file itself. Without include paths it finds none, and a changed header runs no moc again. By default it would wait until
# the libraries of its target are built (AUTOGEN_ORIGIN_DEPENDS), and so would the compilation of the target's own files.
get_target_property(skyseal_moc Qt6::moc LOCATION)
configure_file(${CMAKE_CURRENT_LIST_DIR}/moc.in ${CMAKE_BINARY_DIR}/moc @ONLY
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
function(skyseal_automoc target)
  set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE ${CMAKE_BINARY_DIR}/moc
    AUTOGEN_ORIGIN_DEPENDS OFF)
  # Source files include the output of moc for their headers, which they have read already. What is left for this file is
  # nearly nothing, quicker to compile than a precompiled header is to load.
  set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/mocs_compilation.cpp
    PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()

if(SKYSEAL_SANITIZE)
  add_compile_options(-fsanitize=${SKYSEAL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${SKYSEAL_SANITIZE})
  set(skyseal_sanitized SKYSEAL_SANITIZED) # a definition for tests; the list has commas, which generator expressions do not take
endif()
if(SKYSEAL_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(SKYSEAL_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()

include(SkysealPrecompiled)

if(SKYSEAL_UNITY AND NOT SKYSEAL_UNITY MATCHES "^(GROUPS|WHOLE)$")
  message(FATAL_ERROR "SKYSEAL_UNITY is ${SKYSEAL_UNITY}: expected GROUPS, WHOLE or nothing")
endif()

# Headers that change often and that many files need. A change of one compiles the groups of its users (below) and no others.
set(skyseal_wide_headers core/base/secret_bytes.h core/channel/endpoint.h core/engine/station/snapshot.h)
# Files that patches of tests/weakened change; the weakened twins compile copies of them.
set(skyseal_patched_files)
if(SKYSEAL_PROOFS)
  file(GLOB skyseal_weakness_patches CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/weakened/patches/*.patch)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${skyseal_weakness_patches})
  foreach(patch IN LISTS skyseal_weakness_patches)
    file(STRINGS ${patch} lines REGEX "^[+][+][+] b/")
    list(TRANSFORM lines REPLACE "^[+][+][+] b/" "")
    list(APPEND skyseal_patched_files ${lines})
  endforeach()
  list(REMOVE_DUPLICATES skyseal_patched_files)
endif()

# skyseal_notable_includes(FILE OUT): which of these files FILE is or includes, also by other headers; none if it is still to be
# generated.
function(skyseal_notable_includes file out)
  if(NOT EXISTS ${file})
    set(${out} "" PARENT_SCOPE)
    return()
  endif()
  get_property(found GLOBAL PROPERTY "skyseal_notable_includes ${file}")
  get_property(known GLOBAL PROPERTY "skyseal_notable_includes ${file}" SET)
  if(NOT known)
    set_property(GLOBAL PROPERTY "skyseal_notable_includes ${file}" "") # for headers that include each other
    cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    if(name IN_LIST skyseal_patched_files)
      list(APPEND found ${name})
    endif()
    cmake_path(GET file PARENT_PATH folder)
    file(STRINGS ${file} lines REGEX "^#include \"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" header ${line})
      if(header IN_LIST skyseal_wide_headers)
        list(APPEND found ${header})
      endif()
      foreach(place ${PROJECT_SOURCE_DIR} ${folder})
        if(EXISTS ${place}/${header})
          skyseal_notable_includes(${place}/${header} deeper)
          list(APPEND found ${deeper})
          break()
        endif()
      endforeach()
    endforeach()
    list(REMOVE_DUPLICATES found)
    list(SORT found)
    set_property(GLOBAL PROPERTY "skyseal_notable_includes ${file}" "${found}")
  endif()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# skyseal_group(FILE TARGET OUT): with which others of TARGET FILE, a whole path, is compiled. With SKYSEAL_PROOFS the files that
# are or include a patched one and the attack tests have groups of their own, since the weakened twins compile the former again and
# take the objects of the latter. WHOLE: about 24 files in a group. GROUPS: the users of the same wide headers are one; those of none
# are in eight in the tests and the window, and in three elsewhere. A target of a few files (SKYSEAL_SMALL) has one such group.
function(skyseal_group file target out)
  cmake_path(GET file FILENAME name)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(small ${target} SKYSEAL_SMALL)
  set(group)
  if(SKYSEAL_PROOFS AND name MATCHES "^attack_")
    list(APPEND group attack)
  endif()
  skyseal_notable_includes(${file} headers)
  foreach(header IN LISTS headers)
    if(NOT header IN_LIST skyseal_patched_files)
      if(SKYSEAL_UNITY STREQUAL "GROUPS")
        cmake_path(GET header STEM stem)
        list(APPEND group ${stem})
      endif()
    elseif(SKYSEAL_PROOFS)
      list(APPEND group weakened)
    endif()
  endforeach()
  if(group OR small)
    set(groups 1)
  elseif(SKYSEAL_UNITY STREQUAL "WHOLE")
    file(GLOB_RECURSE sources ${folder}/*.cpp)
    list(LENGTH sources count)
    math(EXPR groups "(${count} + 23) / 24")
  elseif(folder MATCHES "^${PROJECT_SOURCE_DIR}/(tests|ui)(/|$)")
    set(groups 8)
  else()
    set(groups 3)
  endif()
  string(MD5 hash ${name})
  string(SUBSTRING ${hash} 0 2 digits)
  math(EXPR number "0x${digits} % ${groups}")
  list(REMOVE_DUPLICATES group)
  list(SORT group)
  list(APPEND group ${number})
  list(JOIN group _ group)
  set(${out} ${group} PARENT_SCOPE)
endfunction()

# skyseal_unite(TARGET SOURCE …): compiles these source files of one folder in the groups that SKYSEAL_UNITY names, if any.
function(skyseal_unite target)
  if(NOT SKYSEAL_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder)
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    skyseal_group(${source} ${target} group)
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
  # A class with members of types from an anonymous namespace is as local in an included source file as in its own.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# skyseal_library(NAME SOURCES … PUBLIC … PRIVATE … [QT [WIDGETS]]): the static library skyseal_NAME, alias skyseal::NAME.
# Without QT it has no include path of Qt, which enforces the rule that the protocol layers do not use Qt.
function(skyseal_library name)
  cmake_parse_arguments(arg "QT;WIDGETS" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(skyseal_${name} STATIC ${arg_SOURCES})
  add_library(skyseal::${name} ALIAS skyseal_${name})
  target_link_libraries(skyseal_${name} PUBLIC skyseal_options ${arg_PUBLIC} PRIVATE skyseal_hardening ${arg_PRIVATE})
  skyseal_unite(skyseal_${name} ${arg_SOURCES})
  if(arg_QT)
    skyseal_automoc(skyseal_${name})
  endif()
  if(arg_WIDGETS)
    skyseal_precompile(skyseal_${name} ui)
  else()
    skyseal_precompile_layer(skyseal_${name} "${arg_QT}")
  endif()
endfunction()

# skyseal_program(NAME SOURCES … LINK … COMPONENT …): a program that is installed.
function(skyseal_program name)
  cmake_parse_arguments(arg "" "COMPONENT" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  list(LENGTH arg_SOURCES count)
  if(count GREATER 1)
    skyseal_unite(${name} ${arg_SOURCES})
  endif()
  skyseal_automoc(${name})
  target_compile_definitions(${name} PRIVATE SKYSEAL_VERSION="${PROJECT_VERSION}")
  target_link_libraries(${name} PRIVATE skyseal_options skyseal_hardening ${arg_LINK})
  skyseal_precompile(${name} engine)
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${arg_COMPONENT})
endfunction()

# skyseal_test_program(NAME [WIDGETS]): a program of QtTest classes in tests/ of the build folder. tests/support/test_runner.h
# says how it runs one of them.
function(skyseal_test_program name)
  cmake_parse_arguments(arg "WIDGETS" "" "" ${ARGN})
  add_executable(${name})
  skyseal_automoc(${name})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_link_libraries(${name} PRIVATE skyseal_options skyseal_test_runner Qt6::Test Qt6::Network)
  target_compile_options(${name} PRIVATE ${SKYSEAL_TEST_OPTIONS})
  target_compile_definitions(${name} PRIVATE
    SKYSEAL_SOURCE_DIR="${PROJECT_SOURCE_DIR}" SKYSEAL_BIN_DIR="${CMAKE_BINARY_DIR}/bin")
  if(arg_WIDGETS)
    target_link_libraries(${name} PRIVATE Qt6::Widgets)
    skyseal_precompile(${name} ui_tests)
  else()
    skyseal_precompile(${name} tests)
  endif()
endfunction()

# skyseal_test_library(NAME KIND SOURCES … LINK …): a static library that tests share, with the precompiled headers of KIND.
function(skyseal_test_library name kind)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${name} PUBLIC skyseal_options ${arg_LINK} PRIVATE skyseal_hardening)
  list(FILTER arg_SOURCES EXCLUDE REGEX "^[$]") # objects of another target
  set_target_properties(${name} PROPERTIES SKYSEAL_SMALL ON)
  skyseal_unite(${name} ${arg_SOURCES})
  skyseal_precompile(${name} ${kind})
endfunction()

# skyseal_test(NAME SOURCES … LINK … LABELS … [NEEDS PROGRAM …] [DEFINE …] [TIMEOUT S] [ALONE]
#              [REQUIRES REQUIREMENT …] [APART REQUIREMENT:FUNCTION …] [WITHOUT FUNCTION …])
# One QtTest class, that of the first source file, as the ctest entry NAME. All classes of a folder are in the program
# FOLDER_tests. ALONE gives the class a program NAME of its own, for one that replaces operator new or starts itself again.
# NEEDS names the programs and libraries that the test starts or loads, DEFINE macros for its sources. REQUIRES: see
# skyseal_requires(); a class of which only some functions require something has them APART, each as an entry NAME.FUNCTION.
# Functions that cannot run in this build, such as under a sanitizer, are left out by WITHOUT.
function(skyseal_test name)
  cmake_parse_arguments(arg "ALONE" "TIMEOUT" "SOURCES;LINK;LABELS;NEEDS;DEFINE;REQUIRES;APART;WITHOUT" ${ARGN})
  list(GET arg_SOURCES 0 class)
  cmake_path(GET class STEM class)
  if(arg_ALONE)
    set(program ${name})
  else()
    cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder)
    set(program ${folder}_tests)
  endif()
  if(NOT TARGET ${program})
    if("gui" IN_LIST arg_LABELS)
      skyseal_test_program(${program} WIDGETS)
    else()
      skyseal_test_program(${program})
    endif()
  endif()
  target_sources(${program} PRIVATE ${arg_SOURCES})
  target_link_libraries(${program} PRIVATE ${arg_LINK})
  set_target_properties(${program} PROPERTIES SKYSEAL_SMALL ${arg_ALONE})
  skyseal_unite(${program} ${arg_SOURCES})
  if(arg_DEFINE)
    set_source_files_properties(${arg_SOURCES} PROPERTIES COMPILE_DEFINITIONS "${arg_DEFINE}")
  endif()
  if(arg_NEEDS)
    add_dependencies(${program} ${arg_NEEDS})
  endif()
  if(arg_ALONE)
    set(class) # the program holds no other
  endif()
  foreach(apart IN LISTS arg_APART)
    string(REGEX MATCH "^(.+):(.+)$" apart ${apart})
    list(APPEND arg_WITHOUT ${CMAKE_MATCH_2})
    skyseal_test_entry(${name}.${CMAKE_MATCH_2} ${program} ARGUMENTS ${class} ${CMAKE_MATCH_2} LABELS ${arg_LABELS}
      TIMEOUT ${arg_TIMEOUT} REQUIRES ${CMAKE_MATCH_1})
  endforeach()
  list(TRANSFORM arg_WITHOUT PREPEND "-without;")
  skyseal_test_entry(${name} ${program} ARGUMENTS ${class} ${arg_WITHOUT} LABELS ${arg_LABELS} TIMEOUT ${arg_TIMEOUT}
    REQUIRES ${arg_REQUIRES})
endfunction()

# skyseal_requires(ENTRY REQUIREMENT …): the ctest entry ENTRY may be skipped, by exiting with 77, if one of these requirements is
# missing (tests/support/requirements.cpp). An entry that exits so without it fails. ctest runs requires_REQUIREMENT first.
function(skyseal_requires entry)
  set_tests_properties(${entry} PROPERTIES SKIP_RETURN_CODE 77 FIXTURES_REQUIRED "${ARGN}")
  get_test_property(${entry} LABELS labels)
  set_property(GLOBAL APPEND PROPERTY skyseal_requirements ${ARGN})
  if(NOT "slow" IN_LIST labels)
    set_property(GLOBAL APPEND PROPERTY skyseal_usual_requirements ${ARGN})
  endif()
endfunction()

# Declares requires_REQUIREMENT for each requirement of an entry so far; slow, if only slow entries have it.
function(skyseal_requirement_entries)
  get_property(requirements GLOBAL PROPERTY skyseal_requirements)
  get_property(usual GLOBAL PROPERTY skyseal_usual_requirements)
  list(REMOVE_DUPLICATES requirements)
  foreach(requirement IN LISTS requirements)
    set(labels requirement)
    if(NOT requirement IN_LIST usual)
      list(APPEND labels slow)
    endif()
    skyseal_test_entry(requires_${requirement} support_tests ARGUMENTS requirements_test isMet:${requirement} LABELS ${labels})
    set_tests_properties(requires_${requirement} PROPERTIES SKIP_RETURN_CODE 77 FIXTURES_SETUP ${requirement})
  endforeach()
endfunction()

# skyseal_test_entry(NAME PROGRAM ARGUMENTS … LABELS … [TIMEOUT S] [ENVIRONMENT …] [REQUIRES …]): one more ctest entry of a test
# program.
function(skyseal_test_entry name program)
  cmake_parse_arguments(arg "" "TIMEOUT" "ARGUMENTS;LABELS;ENVIRONMENT;REQUIRES" ${ARGN})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 240) # so that a test can report its own deadline (tests/support/eventually.h) before it is killed
  endif()
  if(SKYSEAL_SANITIZE)
    math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * 3")
  endif()
  math(EXPR milliseconds "${arg_TIMEOUT} * 1000") # QtTest alone would end each function after five minutes, all of its rows together
  add_test(NAME ${name} COMMAND ${program} ${arg_ARGUMENTS})
  # ctest starts the longest ones first, so that none of them is left alone at the end.
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT} COST ${arg_TIMEOUT}
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;QTEST_FUNCTION_TIMEOUT=${milliseconds};TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/cmake/tsan.supp die_after_fork=0;UBSAN_OPTIONS=print_stacktrace=1;LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/cmake/lsan.supp print_suppressions=0;${arg_ENVIRONMENT}")
  if(arg_REQUIRES)
    skyseal_requires(${name} ${arg_REQUIRES})
    add_dependencies(${program} support_tests) # where the requirements are checked
  endif()
endfunction()

# skyseal_fuzzer(NAME [QT] SOURCES … LINK … CORPUS DIR): a libFuzzer target under the fuzz preset, where `--target fuzzers` builds
# all of them; in every other build the same entry point replays the corpus under ctest.
function(skyseal_fuzzer name)
  cmake_parse_arguments(arg "QT" "CORPUS" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/fuzz)
  target_link_libraries(${name} PRIVATE skyseal_options skyseal_hardening ${arg_LINK})
  skyseal_precompile_layer(${name} "${arg_QT}")
  if(SKYSEAL_FUZZ)
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
    if(NOT TARGET fuzzers)
      add_custom_target(fuzzers)
    endif()
    add_dependencies(fuzzers ${name})
  else()
    target_link_libraries(${name} PRIVATE replay_corpus)
    add_test(NAME ${name} COMMAND ${name} ${arg_CORPUS})
    set_tests_properties(${name} PROPERTIES LABELS fuzz-smoke TIMEOUT 60)
  endif()
endfunction()

# skyseal_benchmark(NAME [QT] SOURCES … LINK …): a Google Benchmark program; `cmake --build … --target bench` runs all.
function(skyseal_benchmark name)
  cmake_parse_arguments(arg "QT" "" "SOURCES;LINK" ${ARGN})
  if(NOT SKYSEAL_BENCH)
    return()
  endif()
  find_package(benchmark REQUIRED)
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bench)
  target_link_libraries(${name} PRIVATE skyseal_options skyseal_hardening benchmark::benchmark ${arg_LINK})
  skyseal_precompile_layer(${name} "${arg_QT}")
  if(NOT TARGET bench)
    add_custom_target(bench)
    add_custom_target(bench_programs)
  endif()
  add_dependencies(bench_programs ${name})
  # One after the other, and after the last compiler has ended: they would disturb each other.
  get_property(previous GLOBAL PROPERTY SKYSEAL_LAST_BENCHMARK)
  add_custom_target(run_${name} COMMAND ${name} --benchmark_min_time=0.05 USES_TERMINAL)
  add_dependencies(run_${name} bench_programs ${previous})
  set_property(GLOBAL PROPERTY SKYSEAL_LAST_BENCHMARK run_${name})
  add_dependencies(bench run_${name})
endfunction()
