// SPDX-License-Identifier: MIT
#include "backend/cpu/threads.h"

#include <omp.h>

#include <exception>

namespace freshet {

int Threads::current() { return omp_get_thread_num(); }

void Threads::run(int parts, const void* context, void (*part)(const void*, int)) const {
  std::exception_ptr error;
#pragma omp parallel for num_threads(count_) schedule(dynamic, 1) if (parts > 1)
  for (int k = 0; k < parts; ++k) {
    try {
      part(context, k);
    } catch (...) {  // an exception must not leave the loop
#pragma omp critical(freshet_error)
      error = std::current_exception();
    }
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace freshet
