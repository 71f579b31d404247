# The libraries for programs of others: find_package(wetdeck) gives wetdeck::solver,
# find_package(wetdeck COMPONENTS harness) also what reads scenes, runs, stores, compares and reports.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(wetdeck_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/wetdeck)

# A library whose headers others include as "solver/simulation.hpp" or <wetdeck/solver/simulation.hpp>.
function(wetdeck_public_library target component)
  string(REGEX REPLACE "^wetdeck_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR};${CMAKE_INSTALL_INCLUDEDIR}/wetdeck>")
  install(TARGETS ${target} EXPORT wetdeck_${component} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
endfunction()

function(wetdeck_install_libraries)
  foreach(component solver harness)
    install(EXPORT wetdeck_${component} NAMESPACE wetdeck:: DESTINATION ${wetdeck_package_folder} COMPONENT development)
  endforeach()
  # Not those that only the library's own sources include, nor those that come with the program.
  install(DIRECTORY solver validation DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/wetdeck COMPONENT development
          FILES_MATCHING PATTERN "*.hpp" PATTERN program EXCLUDE PATTERN scenes EXCLUDE PATTERN paraview EXCLUDE
          PATTERN simd EXCLUDE PATTERN substep_weight.hpp EXCLUDE PATTERN isa_passes.hpp
          EXCLUDE PATTERN wall_pair.hpp EXCLUDE PATTERN toml_node.hpp EXCLUDE PATTERN instruction_sets.hpp EXCLUDE PATTERN sections.hpp EXCLUDE)
  install(FILES reports/report.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/wetdeck/reports COMPONENT development)
  install(FILES reports/page/report_inputs.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/wetdeck/reports/page COMPONENT development)
  configure_package_config_file(cmake/wetdeck-config.cmake.in ${PROJECT_BINARY_DIR}/wetdeck-config.cmake
                                INSTALL_DESTINATION ${wetdeck_package_folder})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/wetdeck-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/wetdeck-config.cmake ${PROJECT_BINARY_DIR}/wetdeck-config-version.cmake cmake/FindUDUNITS2.cmake
          DESTINATION ${wetdeck_package_folder} COMPONENT development)
endfunction()
