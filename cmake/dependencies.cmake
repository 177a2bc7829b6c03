# The libraries that foldless is built with; all of them come from the system.

find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
if(FOLDLESS_SANITIZE MATCHES "thread")
  # Debian's library is not instrumented: loops on threads that the sanitizer knows stand in for it.
  set(TBB_DIR "${PROJECT_SOURCE_DIR}/tests/threads")
endif()
find_package(TBB REQUIRED)
find_package(OpenMesh REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(CGAL 5.5 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(OpenEXR 3.1 REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
if(FOLDLESS_BUILD_TOOLS)
  find_package(CLI11 REQUIRED)
endif()

# Interval arithmetic changes the rounding mode, so whoever uses CGAL must not have the compiler move arithmetic across
# such a change. CGAL asks GNU for that and nobody else; Clang knows the same option.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(CGAL INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-frounding-math>)
endif()
