# SPDX-License-Identifier: MIT
# Copies the licences of the libraries and fonts in the archive to share/doc/freshet.
set(prefix "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
file(GLOB files RELATIVE ${prefix} ${prefix}/lib*/freshet/*.so* ${prefix}/share/freshet/fonts/*.ttf
  ${prefix}/lib/*/freshet/*.so*)
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  execute_process(COMMAND dpkg-query --search */${name} OUTPUT_VARIABLE owners ERROR_QUIET)
  string(REGEX MATCHALL "(^|\n)[a-z0-9.+-]+:" owners "${owners}")
  foreach(owner ${owners})
    string(REGEX REPLACE "[\n:]" "" owner ${owner})
    list(APPEND packages ${owner})
  endforeach()
endforeach()
list(APPEND packages libimgui-dev libstb-dev)  # in the window, linked statically
list(REMOVE_DUPLICATES packages)
foreach(package ${packages})
  if(EXISTS /usr/share/doc/${package}/copyright)
    file(COPY /usr/share/doc/${package}/copyright DESTINATION ${prefix}/share/doc/freshet/${package}
      FOLLOW_SYMLINK_CHAIN)
  endif()
endforeach()
