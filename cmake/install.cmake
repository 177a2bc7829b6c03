# Installs the libraries, their headers, the program, and the package that find_package(foldless) finds.
include(CMakePackageConfigHelpers)

set(FOLDLESS_PACKAGE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/foldless")
set(FOLDLESS_INSTALLED_LAYERS predicates io images decimate verify repair bake report)

foreach(layer IN LISTS FOLDLESS_INSTALLED_LAYERS)
  install(TARGETS foldless_${layer} EXPORT foldlessTargets)
  get_target_property(headers foldless_${layer} FOLDLESS_HEADERS)
  foreach(header IN LISTS headers)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES "${PROJECT_SOURCE_DIR}/${layer}/${header}"
      DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/foldless/${layer}/${folder}")
  endforeach()
endforeach()
if(FOLDLESS_BUILD_TOOLS)
  install(TARGETS foldless_program)
endif()
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# The package finds what the exported targets name, no more: the part before `::` of each, or OpenMesh or Embree, whose
# targets have no such part.
function(foldless_packages_of_exported_targets result)
  set(packages)
  foreach(layer IN LISTS FOLDLESS_INSTALLED_LAYERS)
    get_target_property(libraries foldless_${layer} INTERFACE_LINK_LIBRARIES)
    list(FILTER libraries EXCLUDE REGEX "BUILD_INTERFACE")
    foreach(library IN LISTS libraries)
      if(library MATCHES "([A-Za-z0-9_]+)::" AND NOT CMAKE_MATCH_1 STREQUAL "foldless")
        list(APPEND packages ${CMAKE_MATCH_1})
      elseif(library MATCHES "OpenMesh(Core|Tools)")
        list(APPEND packages OpenMesh)
      elseif(library MATCHES "embree")
        list(APPEND packages embree)
      endif()
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES packages)
  set(${result} ${packages} PARENT_SCOPE)
endfunction()

foldless_packages_of_exported_targets(packages)
set(FOLDLESS_FIND_DEPENDENCIES)
foreach(package IN LISTS packages)
  string(APPEND FOLDLESS_FIND_DEPENDENCIES "find_dependency(${package})\n")
endforeach()

configure_package_config_file(cmake/foldlessConfig.cmake.in "${PROJECT_BINARY_DIR}/foldlessConfig.cmake"
  INSTALL_DESTINATION "${FOLDLESS_PACKAGE_DIR}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/foldlessConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/foldlessConfig.cmake" "${PROJECT_BINARY_DIR}/foldlessConfigVersion.cmake"
  DESTINATION "${FOLDLESS_PACKAGE_DIR}")
install(EXPORT foldlessTargets NAMESPACE foldless:: DESTINATION "${FOLDLESS_PACKAGE_DIR}")
