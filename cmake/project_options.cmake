# What every target of the project is compiled with.
add_library(wetdeck_options INTERFACE)
target_compile_features(wetdeck_options INTERFACE cxx_std_20)
target_compile_options(wetdeck_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual -Werror)

set(WETDECK_SANITIZE "" CACHE STRING "Sanitizers to build with, for example address,undefined")
if(WETDECK_SANITIZE)
  target_compile_options(wetdeck_options INTERFACE -fsanitize=${WETDECK_SANITIZE} -fno-omit-frame-pointer
                         -fno-sanitize-recover=all
                         # these checks, most of them of pointers, multiply the time of compilation
                         $<$<CXX_COMPILER_ID:GNU>:-fno-sanitize=null,alignment,object-size,vptr,return>
                         # g++ 12 takes std::regex for uninitialised once it is instrumented
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(wetdeck_options INTERFACE -fsanitize=${WETDECK_SANITIZE})
endif()

option(WETDECK_FUZZ "Build the fuzz targets of tests/fuzz (clang++)" OFF)
if(WETDECK_FUZZ)
  target_compile_options(wetdeck_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
