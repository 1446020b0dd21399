// SPDX-License-Identifier: MIT
/** Sums of the native program after 2000 steps of the scene `article`, of the state and of the pixels
    of the picture. tests/sim/article_golden_test.cpp has the same. */
export const native = {
  state: '209739a4641c59b9a1dc195b15a58aee12ca9bf8bd28091793e8a501958e80de',
  picture: '3758a24fbff9fbc8eeafc4ffa23dbb22f8c656d39b549e945d690c54cfdf23b5',
};
