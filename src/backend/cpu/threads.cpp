// SPDX-License-Identifier: MIT
#include "backend/cpu/threads.h"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <exception>

namespace freshet {

int Threads::current() {
#ifdef _OPENMP
  return omp_get_thread_num();
#else
  return 0;
#endif
}

void Threads::run(int parts, const void* context, void (*part)(const void*, int)) const {
  std::exception_ptr error;
#ifdef _OPENMP
#pragma omp parallel for num_threads(count_) schedule(dynamic, 1) if (parts > 1)
#endif
  for (int k = 0; k < parts; ++k) {
    try {
      part(context, k);
    } catch (...) {  // an exception must not leave the loop
#ifdef _OPENMP
#pragma omp critical(freshet_error)
#endif
      error = std::current_exception();
    }
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace freshet
