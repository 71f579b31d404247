# Target wetdeck_build_info: headers wetdeck_build/build_info.hpp (version, compiler, flags, libraries, fixed when
# the project is configured) and wetdeck_build/git_revision.hpp (at build time).
include(git_revision)

function(wetdeck_define_build_info)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_target_property(options wetdeck_options INTERFACE_COMPILE_OPTIONS)
  list(JOIN options " " options)
  string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${options}" flags)
  # Flags may name folders; whose they are is nobody's business.
  foreach(folder IN ITEMS "${PROJECT_SOURCE_DIR}" "$ENV{HOME}")
    if(NOT folder STREQUAL "" AND NOT folder STREQUAL "/")
      string(REPLACE "${folder}" "<folder>" flags "${flags}")
    endif()
  endforeach()

  set(libraries "")
  foreach(library IN ITEMS Eigen3 HDF5 GSL fmt nlohmann_json tomlplusplus muparser CLI11 VTK)
    if(${library}_VERSION)
      list(APPEND libraries "${library} ${${library}_VERSION}")
    endif()
  endforeach()
  list(JOIN libraries ", " libraries)

  set(folder ${CMAKE_BINARY_DIR}/generated)
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/build_info.hpp.in ${folder}/wetdeck_build/build_info.hpp @ONLY)
  wetdeck_git_revision_header(wetdeck_git_revision ${folder}/wetdeck_build/git_revision.hpp)
  add_library(wetdeck_build_info INTERFACE)
  target_include_directories(wetdeck_build_info INTERFACE ${folder})
  add_dependencies(wetdeck_build_info wetdeck_git_revision)
endfunction()

wetdeck_define_build_info()
