# SPDX-License-Identifier: MIT
# The build for browsers (web/build): freshet_sim by Emscripten, without threads and optional
# libraries. The headers of toml++ and fmt are those of this system. They are copied, since the other
# headers of /usr/include are not for WebAssembly.
set(FRESHET_RUN OFF)
set(FRESHET_SOLVERS mueller2003 wcsph delta_sph pcisph iisph dfsph pbf)
set(FRESHET_REFERENCE_SOLVERS mueller2003)  # of the article's scene
set(FRESHET_REFERENCE_3D OFF)
set(headers ${PROJECT_BINARY_DIR}/headers)
foreach(library toml++ fmt)
  find_path(${library}_folder ${library} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH
            NO_DEFAULT_PATH REQUIRED)
  file(COPY ${${library}_folder}/${library} DESTINATION ${headers})
endforeach()
add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED)
target_compile_definitions(tomlplusplus::tomlplusplus INTERFACE TOML_FLOAT_CHARCONV=0)
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
foreach(library tomlplusplus::tomlplusplus fmt::fmt)
  target_include_directories(${library} INTERFACE ${headers})
endforeach()
add_compile_options(-fwasm-exceptions -msimd128)
add_link_options(-fwasm-exceptions)
