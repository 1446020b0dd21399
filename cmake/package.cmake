# SPDX-License-Identifier: MIT
# `cmake --build DIR --target package` writes a Debian package, which depends on Debian's libraries,
# and an archive that has its libraries and fonts with it. Both run on a bare Debian of the release
# that built them. scripts/package calls this, and makes the package of the Python module as well.
include(GNUInstallDirs)

# Libraries and fonts of the archive: not part of `cmake --install`.
install(RUNTIME_DEPENDENCY_SET freshet_libraries
  PRE_EXCLUDE_REGEXES "^(ld-linux-.*|lib(c|dl|m|pthread|resolv|rt))\\.so" # the C library
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/freshet COMPONENT archive EXCLUDE_FROM_ALL)
find_path(FRESHET_FONTS DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu NO_DEFAULT_PATH)
if(FRESHET_FONTS)
  install(FILES ${FRESHET_FONTS}/DejaVuSans.ttf ${FRESHET_FONTS}/DejaVuSans-Bold.ttf
    ${CMAKE_CURRENT_LIST_DIR}/fonts.conf
    DESTINATION ${CMAKE_INSTALL_DATADIR}/freshet/fonts COMPONENT archive EXCLUDE_FROM_ALL)
endif()
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/copyrights.cmake COMPONENT archive EXCLUDE_FROM_ALL)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/freshet RENAME copyright)

set(CPACK_GENERATOR DEB TZST)
set(CPACK_PACKAGE_CONTACT "The Freshet authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Fluid simulator: smoothed particle hydrodynamics")
set(CPACK_PACKAGE_FILE_NAME freshet-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, paraview, blender")
if(FRESHET_PYTHON_MODULE)  # of this version of Python only
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_FRESHET_PYTHON "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next})")
endif()
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/package_format.cmake)
include(CPack)
