# The revision of the sources, taken whenever the program is built, not when it is configured.
#   wetdeck_git_revision_header(TARGET HEADER)   a target that rewrites HEADER when the revision has changed
# The same file, run by cmake -P with SOURCE_DIR and HEADER, is the build step.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(WETDECK_GIT_REVISION_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(wetdeck_git_revision_header target header)
    add_custom_target(${target} BYPRODUCTS ${header} COMMENT "Looking up the revision" VERBATIM
      COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DHEADER=${header}
              -P ${WETDECK_GIT_REVISION_SCRIPT})
  endfunction()
  return()
endif()

find_program(GIT git)
function(git output)
  set(${output} "" PARENT_SCOPE)
  if(GIT)
    execute_process(COMMAND ${GIT} --no-optional-locks -C ${SOURCE_DIR} ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE text
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed)
      set(${output} "${text}" PARENT_SCOPE)
    endif()
  endif()
endfunction()

set(revision unknown)
# A copy of the sources unpacked inside somebody else's repository has no revision of its own.
git(prefix rev-parse --show-cdup)
git(head rev-parse --short=12 --verify HEAD)
if(head AND prefix STREQUAL "")
  git(changes status --porcelain --untracked-files=no)
  set(revision "${head}")
  if(NOT changes STREQUAL "")
    string(APPEND revision "-dirty")
  endif()
endif()

set(text "// Written by git_revision.cmake at build time.
#pragma once

namespace wetdeck::build {
inline constexpr const char* revision = \"${revision}\";
}  // namespace wetdeck::build
")
set(previous "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} previous)
endif()
if(NOT text STREQUAL previous)
  file(WRITE ${HEADER} "${text}")
endif()
