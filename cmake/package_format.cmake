# SPDX-License-Identifier: MIT
# What goes into a package of CPACK_GENERATOR; cpack reads this.
list(GET CPACK_INSTALL_CMAKE_PROJECTS 0 build)
set(CPACK_INSTALL_CMAKE_PROJECTS "${build};freshet;Unspecified;/")
if(CPACK_GENERATOR STREQUAL TZST)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${build};freshet;archive;/")
endif()
# The module for Python is a package of its own: cpack -G DEB -D FRESHET_PART=python
if(FRESHET_PART STREQUAL python)
  set(CPACK_INSTALL_CMAKE_PROJECTS "${build};freshet;python;/")
  set(CPACK_DEBIAN_PACKAGE_NAME python3-freshet)
  set(CPACK_DEBIAN_PACKAGE_SECTION python)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Fluid simulator: smoothed particle hydrodynamics, for Python")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "freshet (= ${CPACK_PACKAGE_VERSION}), python3-numpy, ${CPACK_FRESHET_PYTHON}")
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas, python3-tqdm")
endif()
