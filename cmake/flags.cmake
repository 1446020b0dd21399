# SPDX-License-Identifier: MIT
# Compiler flags of all targets. Contraction is off, so that every machine computes the same bits.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

add_library(freshet_flags INTERFACE)
target_compile_options(freshet_flags INTERFACE -Wall -Wextra -Wpedantic -Werror
                                               -ffp-contract=off -fno-math-errno
                                               -fno-trapping-math)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # g++ 12 warns of overlaps and overflows inside std and fmt
  target_compile_options(freshet_flags INTERFACE -Wshadow=local -Wno-restrict -Wno-stringop-overflow
                                                 -Wno-maybe-uninitialized)
endif()
target_include_directories(freshet_flags INTERFACE ${PROJECT_SOURCE_DIR}/src
                                                   ${PROJECT_SOURCE_DIR}/include
                                                   ${PROJECT_BINARY_DIR}/include)
if(FRESHET_DOUBLE)
  target_compile_definitions(freshet_flags INTERFACE FRESHET_DOUBLE)
endif()
if(FRESHET_SANITIZE)
  target_compile_options(freshet_flags INTERFACE -fsanitize=${FRESHET_SANITIZE}
                                                 -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(freshet_flags INTERFACE -fsanitize=${FRESHET_SANITIZE})
endif()

# Where compile time matters more than run time. freshet_quick: tests that compute. freshet_quickest:
# the program and the other tests, which compute little.
add_library(freshet_quick INTERFACE)
target_link_libraries(freshet_quick INTERFACE freshet_flags)
target_compile_options(freshet_quick INTERFACE -O1)
add_library(freshet_quickest INTERFACE)
target_link_libraries(freshet_quickest INTERFACE freshet_flags)
if(FRESHET_SANITIZE)
  target_compile_options(freshet_quickest INTERFACE -O0)
else()
  target_compile_options(freshet_quickest INTERFACE -O1)
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT EMSCRIPTEN AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Caches objects that include a precompiled header too, and shares objects between clones.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
endif()
