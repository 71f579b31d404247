# Reads mutations.txt, for the build and for mutate.cmake.

# Sets `lines_variable` to one line per mutation and `files_variable` to the files of the solver that they concern.
function(read_mutations list lines_variable files_variable)
  file(STRINGS ${list} lines REGEX "^[^#]")
  set(files)
  foreach(line IN LISTS lines)
    split_mutation("${line}" name problem mutated_files marked mutant)
    list(APPEND files ${mutated_files})
  endforeach()
  list(REMOVE_DUPLICATES files)
  set(${lines_variable} "${lines}" PARENT_SCOPE)
  set(${files_variable} "${files}" PARENT_SCOPE)
endfunction()

# Splits a line into variables of these names. `files` becomes a list: the mutated file, then the sources that are
# compiled with it where it is a header.
function(split_mutation line name problem files marked mutant)
  string(REPLACE ";" "<semicolon>" line "${line}")
  string(REPLACE " | " ";" fields "${line}")
  set(index 0)
  foreach(variable ${name} ${problem} ${files} ${marked} ${mutant})
    list(GET fields ${index} field)
    string(REPLACE "<semicolon>" ";" field "${field}")
    if("${variable}" STREQUAL "${files}")
      string(REPLACE " in " ";" field "${field}")
    endif()
    set(${variable} "${field}" PARENT_SCOPE)
    math(EXPR index "${index} + 1")
  endforeach()
endfunction()
