# SPDX-License-Identifier: MIT
# Compiles solvers, pair terms and kernels for GPUs. No fused multiply-add, IEEE division and square
# roots, so that a GPU computes the bits of the CPU.
find_program(NVCC nvcc HINTS /usr/local/cuda/bin ENV CUDA_PATH PATH_SUFFIXES bin)
if(NOT NVCC)
  message(FATAL_ERROR "FRESHET_CUDA is ON, and nvcc is not found: install CUDA 12.1 or newer, or use another preset")
endif()
set(CMAKE_CUDA_COMPILER ${NVCC})
enable_language(CUDA)
if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)  # CMake 3.25 does not know that newer compilers accept it
  set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
  set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20)
endif()
if(CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 12.1)
  message(FATAL_ERROR "nvcc is ${CMAKE_CUDA_COMPILER_VERSION}; 12.1 or newer is needed")
endif()
add_library(freshet_cuda OBJECT src/backend/cuda/compile_solvers.cu)
set_target_properties(freshet_cuda PROPERTIES CUDA_ARCHITECTURES "80;90")
target_include_directories(freshet_cuda PRIVATE src include)
target_compile_definitions(freshet_cuda PRIVATE FRESHET_ISA=cuda)
target_compile_options(freshet_cuda PRIVATE --fmad=false --extended-lambda --Werror all-warnings)
