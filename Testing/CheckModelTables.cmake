# cmake -D SOURCE=<source> -D FOLDER=<folder to write to> -P CheckModelTables.cmake
# Fails when WriteTables.cmake takes a file that is no model, or does not say what is wrong with it.
file(READ "${SOURCE}/Data/Screw.vtu" screw)

# write(CONTENT): makes tables of a folder with this file alone; sets `result` and `said`.
function (write content)
  file(REMOVE_RECURSE "${FOLDER}")
  file(WRITE "${FOLDER}/Changed.vtu" "${content}")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -D "DATA=${FOLDER}" -D "OUTPUT=${FOLDER}/tables.cxx"
      -P "${SOURCE}/Filters/Private/Models/WriteTables.cmake"
    RESULT_VARIABLE result ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  set(result "${result}" PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction ()

# refuses(FROM TO WORDS): a file in which TO stands in place of FROM is an error with these words.
function (refuses from to words)
  string(REPLACE "${from}" "${to}" content "${screw}")
  if (content STREQUAL screw)
    message(FATAL_ERROR "Data/Screw.vtu has no ${from}")
  endif ()
  write("${content}")
  if (result EQUAL 0 OR NOT said MATCHES "Changed.vtu" OR NOT said MATCHES "${words}")
    message(FATAL_ERROR "${to} in place of ${from}, expected ${words}: ${said}")
  endif ()
endfunction ()

write("${screw}")
if (NOT result EQUAL 0)
  message(FATAL_ERROR "Data/Screw.vtu: ${said}")
endif ()
refuses("<Piece" "<Part" "no file of an unstructured grid")
refuses("Name=\"Tension\" format=\"ascii\"" "Name=\"Tension\" format=\"appended\"" "no array Tension of text")
refuses("Name=\"Singular\"" "Name=\"Sharp\"" "no array Singular of text")
refuses("          2.275\n" "\n" "array Tension has 18 numbers instead of 19")
refuses("2.5605 -0.4515 1.3\n" "2.5605 -0.4515\n" "array Points has 56 numbers instead of 57")
