# cmake -DSOURCE=DIR -DOUT=FILE -P BuildCommit.cmake: writes the definition of kBuildCommit (core/experiment/build_commit.h), and
# leaves the file alone where it holds the same, so that nothing is built anew.
set(commit unknown)
find_package(Git QUIET)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --abbrev=12 --exclude=* --dirty=-changed
    WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE found RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(status EQUAL 0)
    set(commit ${found})
  endif()
endif()
set(text "#include \"core/experiment/build_commit.h\"\n\nconst char *const skyseal::experiment::kBuildCommit = \"${commit}\";\n")
if(EXISTS ${OUT})
  file(READ ${OUT} before)
endif()
if(NOT "${before}" STREQUAL "${text}")
  file(WRITE ${OUT} "${text}")
endif()
