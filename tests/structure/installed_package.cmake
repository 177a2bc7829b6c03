# Installs the build BUILD into a fresh folder under WORK, moves it, and builds and runs the program CONSUMER with it.
# The package is moved once so that no path of the build or of the first prefix can be needed.

file(REMOVE_RECURSE "${WORK}")

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install "${BUILD}" --config "${CONFIG}" --prefix "${WORK}/first")
file(RENAME "${WORK}/first" "${WORK}/prefix")

# Builds the program in FOLDER with the compiler options ARGN, and sets VARIABLE to what it prints.
function(output_of_consumer variable folder)
  run(${CMAKE_COMMAND} -S "${CONSUMER}" -B "${folder}" -G "${GENERATOR}" "-DCMAKE_BUILD_TYPE=${CONFIG}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${ARGN}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
  run(${CMAKE_COMMAND} --build "${folder}" --config "${CONFIG}")
  execute_process(COMMAND "${folder}/consumer" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "${output}")
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

output_of_consumer(plain "${WORK}/plain")

# Linked with -ffast-math, a program starts with denormal numbers flushed, and its inline functions reorder sums. What it
# gets is the same, bit for bit.
foreach(flags IN ITEMS "-ffast-math" "-ffast-math -O0" "-fno-exceptions -fno-rtti")
  string(MAKE_C_IDENTIFIER "${flags}" name)
  output_of_consumer(other "${WORK}/${name}" "${flags}")
  if(NOT other STREQUAL plain)
    message(FATAL_ERROR "with ${flags} the result is another: ${other}")
  endif()
endforeach()

if(PROGRAM)
  run("${WORK}/prefix/bin/foldless" --version)
endif()
