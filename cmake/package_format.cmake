# SPDX-License-Identifier: MIT
# What goes into a package of CPACK_GENERATOR; cpack reads this.
list(GET CPACK_INSTALL_CMAKE_PROJECTS 0 build)
set(CPACK_INSTALL_CMAKE_PROJECTS "${build};freshet;Unspecified;/")
if(CPACK_GENERATOR STREQUAL TZST)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${build};freshet;archive;/")
endif()
