// SPDX-License-Identifier: MIT
// The kernels and pair terms as device code: proof that their one source serves a GPU. One thread a
// particle; candidates are all particles. Nothing launches this yet.
#include "boundary/box_walls.h"
#include "kernels/poly6.h"
#include "pairs/density.h"
#include "pairs/mueller2003_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class Term, class Sum>
__global__ void sum_over_all(Term term, Field<Vec<D>> x, int n, Sum* sums) {
  const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
  if (i >= n) return;
  const auto at_i = term.at(i);
  Sum sum{};
  for (int j = 0; j < n; ++j) sum += term(Pair<D, Real>(x[i] - x[j]), at_i, term.at(j));
  sums[i] = sum;
}

template <int D>
__global__ void collide(BoxWalls<D> walls, Field<Vec<D>> x, Field<Vec<D>> v, int n) {
  const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n) walls(x[i], v[i]);
}

template __global__ void sum_over_all(Density<2, Poly6>, Field<Vec<2>>, int, Real*);
template __global__ void sum_over_all(Density<3, Poly6>, Field<Vec<3>>, int, Real*);
template __global__ void sum_over_all(Mueller2003Forces<2>, Field<Vec<2>>, int,
                                      ForceDensities<2, Real>*);
template __global__ void sum_over_all(Mueller2003Forces<3>, Field<Vec<3>>, int,
                                      ForceDensities<3, Real>*);
template __global__ void collide(BoxWalls<2>, Field<Vec<2>>, Field<Vec<2>>, int);
template __global__ void collide(BoxWalls<3>, Field<Vec<3>>, Field<Vec<3>>, int);

}  // namespace FRESHET_ISA
}  // namespace freshet
