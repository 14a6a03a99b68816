# cmake -DSOURCE=… -DTREE=… -DPATCHES=… -DFILES=… -P apply_patches.cmake
# Copies FILES from SOURCE to TREE and applies PATCHES to the copies, in this order. Copies that come out as they are already stay
# untouched, so that nothing is compiled again for them. A patch that does not apply ends the build with its name.
find_program(PATCH patch REQUIRED)
set(new ${TREE}.new)
file(REMOVE_RECURSE ${new})
foreach(file IN LISTS FILES)
  cmake_path(GET file PARENT_PATH folder)
  file(MAKE_DIRECTORY ${new}/${folder} ${TREE}/${folder})
  file(COPY_FILE ${SOURCE}/${file} ${new}/${file})
endforeach()
foreach(patch IN LISTS PATCHES)
  execute_process(COMMAND ${PATCH} --strip=1 --fuzz=0 --batch --forward --no-backup-if-mismatch --directory=${new} --input=${patch}
    RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    cmake_path(GET patch FILENAME name)
    message(FATAL_ERROR "tests/weakened/patches/${name} does not apply any more: adapt it to the changed source file.\n${output}")
  endif()
endforeach()
foreach(file IN LISTS FILES)
  file(READ ${new}/${file} text)
  file(WRITE ${new}/${file} "#include \"tests/weakened/weakness.h\"\n${text}")
  file(COPY_FILE ${new}/${file} ${TREE}/${file} ONLY_IF_DIFFERENT)
endforeach()
