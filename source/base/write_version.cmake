# Writes version.cc from version.cc.in: cmake -D RELEASE=0.1.0 -D ROOT=... -D IN=... -D OUT=... -P write_version.cmake
# Run by every build. The file changes only when the version does, so that nothing else is built anew.
set(VERSION ${RELEASE})
find_package(Git QUIET)
# A source archive may lie within the checkout of another project: its commit would be none of ours.
if(GIT_FOUND AND EXISTS ${ROOT}/.git)
  execute_process(COMMAND ${GIT_EXECUTABLE} --no-optional-locks describe --always --dirty --abbrev=7 --exclude=*
    WORKING_DIRECTORY ${ROOT} OUTPUT_VARIABLE commit RESULT_VARIABLE failed
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(VERSION "${RELEASE} (git commit ${commit})")
  endif()
endif()
configure_file(${IN} ${OUT} @ONLY)
