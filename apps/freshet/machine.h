// SPDX-License-Identifier: MIT
#pragma once

namespace freshet::cli {

/// What this machine can do at most, measured in this process on one thread.
struct Ceilings {
  double flops;             ///< multiply-adds count twice [1/s]
  double bytes_per_second;  ///< read and written by a = b + s c over 96 MiB
};
Ceilings measure_ceilings();

/// The most memory that this process has held so far [bytes].
double peak_memory();

}  // namespace freshet::cli
