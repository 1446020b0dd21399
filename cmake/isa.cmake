# SPDX-License-Identifier: MIT
# The instruction sets that the cpu backend is compiled for, best first. The default is the best one of
# this machine. `base` is portable C++, for other processors and for doubles.
set(FRESHET_FLAGS_sse42 -march=x86-64-v2)
set(FRESHET_FLAGS_avx2 -march=x86-64-v3)
set(FRESHET_FLAGS_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
if(EMSCRIPTEN)  # the intrinsics of SSE4.2, by the SIMD instructions of WebAssembly
  set(FRESHET_FLAGS_sse42 -msimd128 -msse4.2)
endif()
set(every_isa avx512 avx2 sse42)

function(best_isa result)
  if(CMAKE_CROSSCOMPILING)
    set(${result} "${every_isa}" PARENT_SCOPE)
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/best_isa.cpp)
  file(WRITE ${source} [[
int main() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd"))
    return 0;
  return __builtin_cpu_supports("avx2") ? 1 : 2;
}
]])
  try_run(number compiled ${PROJECT_BINARY_DIR} ${source})
  if(NOT compiled)
    message(FATAL_ERROR "The compiler cannot build a program that asks for the instruction set of "
                        "this machine; set FRESHET_ISAS")
  endif()
  list(GET every_isa ${number} isa)
  set(${result} ${isa} PARENT_SCOPE)
endfunction()

if(EMSCRIPTEN)
  set(FRESHET_ISAS "sse42")
elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND NOT FRESHET_DOUBLE)
  if(NOT DEFINED FRESHET_ISAS)
    best_isa(best)
  endif()
  set(FRESHET_ISAS "${best}" CACHE STRING "Instruction sets to compile, best first: avx512;avx2;sse42")
else()
  set(FRESHET_ISAS "base")
endif()
