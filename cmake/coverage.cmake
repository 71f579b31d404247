# Line coverage with clang++ (preset "coverage"). Target report_coverage runs the tests and prints the share of lines that they
# reach in the solver and in the metrics.
option(WETDECK_COVERAGE "Instrument for line coverage (clang++)" OFF)
if(NOT WETDECK_COVERAGE)
  return()
endif()
set(coverage_flags -fprofile-instr-generate -fcoverage-mapping)
target_compile_options(wetdeck_options INTERFACE ${coverage_flags})
target_link_options(wetdeck_options INTERFACE ${coverage_flags})

string(REGEX MATCH "^[0-9]+" clang_version "${CMAKE_CXX_COMPILER_VERSION}")
find_program(LLVM_PROFDATA NAMES llvm-profdata-${clang_version} llvm-profdata REQUIRED)
find_program(LLVM_COV NAMES llvm-cov-${clang_version} llvm-cov REQUIRED)

# Called once the test programs are known: they are what is run and what holds the map of lines.
function(wetdeck_add_coverage_report)
  set(raw ${PROJECT_BINARY_DIR}/coverage)
  set(objects)
  foreach(program IN LISTS ARGN)
    list(APPEND objects -object $<TARGET_FILE:${program}>)
  endforeach()
  list(POP_FRONT objects)  # the first one stands alone
  add_custom_target(report_coverage
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${raw}
    COMMAND ${CMAKE_COMMAND} -E env LLVM_PROFILE_FILE=${raw}/%p.profraw
            ${CMAKE_CTEST_COMMAND} --test-dir ${PROJECT_BINARY_DIR} -L "unit|property|meta" --output-on-failure
    COMMAND sh -c "${LLVM_PROFDATA} merge -sparse -o ${raw}/all.profdata ${raw}/*.profraw"
    COMMAND ${LLVM_COV} report ${objects} -instr-profile=${raw}/all.profdata
            ${PROJECT_SOURCE_DIR}/solver ${PROJECT_SOURCE_DIR}/validation/metrics
    DEPENDS ${ARGN} VERBATIM USES_TERMINAL)
endfunction()
