# Installs the build BUILD into a fresh folder under WORK, moves it, and builds and runs the program CONSUMER with it.
# The package is moved once so that no path of the build or of the first prefix can be needed.

file(REMOVE_RECURSE "${WORK}")

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install "${BUILD}" --config "${CONFIG}" --prefix "${WORK}/first")
file(RENAME "${WORK}/first" "${WORK}/prefix")

run(${CMAKE_COMMAND} -S "${CONSUMER}" -B "${WORK}/build" -G "${GENERATOR}" "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run(${CMAKE_COMMAND} --build "${WORK}/build" --config "${CONFIG}")
run("${WORK}/build/consumer")
if(PROGRAM)
  run("${WORK}/prefix/bin/foldless" --version)
endif()
