# SPDX-License-Identifier: MIT
# Debian's nanoflann is a single header without a CMake package file.
find_path(nanoflann_INCLUDE_DIR nanoflann.hpp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(nanoflann REQUIRED_VARS nanoflann_INCLUDE_DIR)
if(nanoflann_FOUND AND NOT TARGET nanoflann::nanoflann)
  add_library(nanoflann::nanoflann INTERFACE IMPORTED)
  target_include_directories(nanoflann::nanoflann INTERFACE ${nanoflann_INCLUDE_DIR})
endif()
mark_as_advanced(nanoflann_INCLUDE_DIR)
