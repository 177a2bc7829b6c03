# Declares the layers of foldless. A layer is a folder of this name at the top of the tree and a library target of the
# same name; its headers are included as <foldless/LAYER/x.h> in the build tree as after installation.

set(FOLDLESS_INCLUDE_ROOT "${PROJECT_BINARY_DIR}/include")
file(MAKE_DIRECTORY "${FOLDLESS_INCLUDE_ROOT}/foldless")

# What every target of the project is compiled with. Multiply-adds are never contracted: a fused product rounds once
# where the error bounds of the predicates count two roundings, and would differ from one instruction set to the next.
add_library(foldless_settings INTERFACE)
target_compile_features(foldless_settings INTERFACE cxx_std_20)
target_compile_options(foldless_settings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
  -ffp-contract=off $<$<BOOL:${FOLDLESS_WARNINGS_AS_ERRORS}>:-Werror>)
if(FOLDLESS_SANITIZE)
  target_compile_options(foldless_settings INTERFACE -fsanitize=${FOLDLESS_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all
    # GCC warns of its own instrumentation in headers of OpenMesh.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(foldless_settings INTERFACE -fsanitize=${FOLDLESS_SANITIZE})
endif()

# What guides libFuzzer: which branches an input takes. Tests and programs are compiled the same way and ignore it, so
# that one build serves both.
if(FOLDLESS_BUILD_FUZZERS)
  target_compile_options(foldless_settings INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(foldless_settings INTERFACE -fsanitize=fuzzer-no-link)
endif()

# GCC 12 at -O2 drops the rounding of pairs of doubles to float32 and back where its vectoriser of straight-line code
# joins them (io/float32.h): what is decided would differ from what is stored.
target_compile_options(foldless_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

# GCC judges bounds after inlining and takes std::sort of a short array for an overrun. Clang and the sanitizers watch.
target_compile_options(foldless_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)

# Libraries of headers alone that sources of ours include: whoever links an installed layer does not need them.
set(FOLDLESS_HEADER_ONLY CLI11::CLI11 nlohmann_json::nlohmann_json)

# CGAL is headers too, but its numbers call GMP and MPFR, which a static layer passes on.
function(foldless_private_dependencies target)
  foreach(library IN LISTS ARGN)
    if(library STREQUAL "CGAL::CGAL")
      target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:CGAL::CGAL>
        $<INSTALL_INTERFACE:mpfr> $<INSTALL_INTERFACE:gmp>)
    elseif(library IN_LIST FOLDLESS_HEADER_ONLY)
      target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:${library}>)
    else()
      target_link_libraries(${target} PRIVATE ${library})
    endif()
  endforeach()
endfunction()

# foldless_layer(NAME HEADERS... SOURCES... DEPENDS... PRIVATE_DEPENDS...)
function(foldless_layer name)
  cmake_parse_arguments(LAYER "" "" "HEADERS;SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target foldless_${name})
  add_library(${target} ${LAYER_SOURCES} ${LAYER_HEADERS})
  add_library(foldless::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} FOLDLESS_HEADERS "${LAYER_HEADERS}"
    POSITION_INDEPENDENT_CODE ON)
  file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${FOLDLESS_INCLUDE_ROOT}/foldless/${name}" SYMBOLIC)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${FOLDLESS_INCLUDE_ROOT}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${LAYER_DEPENDS} PRIVATE $<BUILD_INTERFACE:foldless_settings>)
  foldless_private_dependencies(${target} ${LAYER_PRIVATE_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY FOLDLESS_LAYERS ${name})
endfunction()
