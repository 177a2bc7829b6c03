# Stands in for the package of oneTBB, for us and for the packages that look for it: see tbb/stand_in.h.
if(NOT TARGET TBB::tbb)
  add_library(TBB::tbb INTERFACE IMPORTED)
  target_include_directories(TBB::tbb INTERFACE "${CMAKE_CURRENT_LIST_DIR}")
  target_link_libraries(TBB::tbb INTERFACE Threads::Threads)
endif()
