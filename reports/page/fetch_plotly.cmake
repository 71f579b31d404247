# Takes plotly.js with npm into SOURCE's build folder: OUTPUT on success, STAMP always.
# Call: cmake -DSOURCE=reports/page -DOUTPUT=.../plotly.min.js -DSTAMP=... -P fetch_plotly.cmake
get_filename_component(folder ${OUTPUT} DIRECTORY)
set(work ${folder}/npm)
set(package ${work}/node_modules/plotly.js-basic-dist-min)
file(MAKE_DIRECTORY ${work})
file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json DESTINATION ${work})

find_program(NPM npm)
if(NPM)
  execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=20000
    WORKING_DIRECTORY ${work} TIMEOUT 120 RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
else()
  set(status "npm was not found")
endif()

if(status STREQUAL "0" AND EXISTS ${package}/plotly-basic.min.js)
  file(READ ${package}/LICENSE licence)
  file(READ ${package}/plotly-basic.min.js library)
  file(WRITE ${OUTPUT} "/*\n${licence}*/\n${library}")
else()
  file(REMOVE ${OUTPUT})
  message("plotly.js is not available (npm ci: ${status}): reports will have static figures only. "
          "To try again, delete ${STAMP} and build.")
endif()
file(TOUCH ${STAMP})
