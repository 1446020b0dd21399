// SPDX-License-Identifier: MIT
#pragma once
#include "forces/monaghan2005.h"
#include "pairs/weiler2018.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Viscosity by backward Euler [Weiler, Koschier, Brand, Bender 2018], which is stable for any
/// step. With L v the acceleration by viscosity, linear in v,
///
///   v' = v + dt L v',  so dv = v' - v solves  (1 - dt L) dv = dt L v
///
/// by conjugate gradients with the blocks of the diagonal as preconditioner, from the dv of the
/// step before [sec. 3.3]. Solving for dv, not for v', leaves out how fast everything moves
/// together: the error is what is left of dt L v, as a share of it. A particle's equation counts
/// with its density over the densest liquid's, which makes the equations symmetric.
template <int D, class B, template <int> class Kernel> class Weiler2018 final : public Force<D, B> {
 public:
  using typename Force<D, B>::Fluid;
  Weiler2018(const ForceParameters<D>& c, Kernel<D> W) : c_(c), W_(W) {}
  static bool acts(const ForceParameters<D>& c) {
    return c.viscosity == ViscosityMethod::weiler2018;
  }

  bool is_implicit() const override { return true; }
  void add_wall_forces(const Fluid& f, const Walls<D>& w, WallForces<D, B>& forces) const override {
    Monaghan2005<D, B, Kernel>::add_reactions(c_, W_, f, w, true, forces);
  }
  void fields(FieldMaker<D>& maker) override {
    maker.make("viscosity_dv", Keep::kept, dv_);
    maker.make("viscosity_left", Keep::scratch, left_);
    maker.make("viscosity_way", Keep::scratch, way_);
    maker.make("viscosity_product", Keep::scratch, product_);
    maker.make("viscosity_diagonal", Keep::scratch, diagonal_);
    maker.make("viscosity_off", Keep::scratch, off_);
  }

  Solve relax(B& backend, const Fluid& f, const Walls<D>& w, Real dt, Field<Vec<D>> v) override {
    const PerLiquid mu = c_.liquids.each(&Liquid::mu, f),
                    lightness = c_.liquids.each(&Liquid::lightness, f);
    const auto dv = dv_;
    find_blocks(backend, f, w, dt, mu, lightness);
    const double start = begin(backend, f, w, dt, v, mu, lightness);
    const Solve done = iterate(backend, f, w, dt, start, mu, lightness);
    backend.for_each("viscosity: end", f, [=] FRESHET_LAMBDA(int i) { v[i] += dv[i]; });
    return done;
  }

  // Public for nvcc, which takes no lambdas from private functions.
  /// Computes the preconditioner (1 + dt M_i)^-1.
  void find_blocks(B& backend, const Fluid& f, const Walls<D>& w, Real dt, const PerLiquid& mu,
                   const PerLiquid& lightness) const {
    const auto diagonal = diagonal_, off = off_;
    backend.sum_pairs(
        "viscosity: blocks", f, over(f, Weiler2018Block{W_, c_.m, c_.eps_h2(), mu, f.rho}),
        over(w.akinci2012, Weiler2018AkinciBlock{W_, c_.eps_h2(), mu, f.rho, w.akinci2012.psi,
                                                 w.akinci2012.friction}),
        over(w.adami2012,
             Weiler2018AdamiBlock{W_, c_.m, c_.rho0, c_.eps_h2(), mu, f.rho, w.adami2012.friction}),
        [=] FRESHET_LAMBDA(int i, const Symmetric<D, Real>& M) {
          const auto inverse = inverse_of_one_and(dt * lightness[i], M);
          diagonal[i] = inverse.diagonal;
          if constexpr (D == 3) off[i] = inverse.off;
          else off[i].x = inverse.off;
        });
  }

  /// Calls finish(i, L v/lightness) for any field of velocities v.
  template <class Finish>
  void multiply(B& backend, const Fluid& f, const Walls<D>& w, Field<Vec<D>> v, const PerLiquid& mu,
                const Finish& finish) const {
    Particles<D> like_v = f;  // share then transforms v at copies as a velocity
    like_v.v = v;
    backend.share("viscosity", like_v, v);
    backend.sum_pairs(
        "viscosity: product", f,
        over(f, Monaghan2005Viscosity{W_, c_.m, c_.eps_h2(), mu, f.rho, v}),
        over(w.akinci2012, Monaghan2005Akinci{W_, c_.eps_h2(), mu, f.rho, v, w.akinci2012.psi,
                                              w.akinci2012.friction}),
        over(w.adami2012, Monaghan2005Adami{W_, c_.m, c_.rho0, c_.eps_h2(), mu, f.rho, v,
                                            w.adami2012.friction, w.adami2012.v, true}),
        finish);
  }

  /// Computes the residual at the initial dv. Returns the norm of dt L v.
  double begin(B& backend, const Fluid& f, const Walls<D>& w, Real dt, Field<Vec<D>> v,
               const PerLiquid& mu, const PerLiquid& lightness) const {
    const auto dv = dv_, left = left_;
    multiply(backend, f, w, v, mu,
             [=] FRESHET_LAMBDA(int i, Vec<D> Lv) { left[i] = (dt * lightness[i]) * Lv; });
    const double size = std::sqrt(weighted(backend, f, left, left, lightness));
    const double most = backend.max("viscosity: sums", f,
                                    [=] FRESHET_LAMBDA(int i) { return double(norm2(dv[i])); });
    if (most > 0)
      multiply(backend, f, w, dv, mu, [=] FRESHET_LAMBDA(int i, Vec<D> Ldv) {
        left[i] += (dt * lightness[i]) * Ldv - dv[i];
      });
    return size;
  }

  /// Preconditioned conjugate gradients  [Saad 2003, algorithm 9.1]
  Solve iterate(B& backend, const Fluid& f, const Walls<D>& w, Real dt, double size,
                const PerLiquid& mu, const PerLiquid& lightness) const {
    const auto dv = dv_, left = left_, way = way_, product = product_;
    double zr_before = 0;
    for (int n = 0;; ++n) {
      const double norm = std::sqrt(weighted(backend, f, left, left, lightness));
      const double error = size > 0 ? norm / size : 0;
      if (!(error > c_.implicit.tolerance) || n >= c_.implicit.most || std::isnan(error))
        return {"viscosity", n, error, c_.implicit.tolerance};
      const double zr = preconditioned(backend, f, lightness);
      const Real beta = zr_before > 0 ? Real(zr / zr_before) : 0;
      zr_before = zr;
      step_way(backend, f, beta);
      multiply(backend, f, w, way, mu, [=] FRESHET_LAMBDA(int i, Vec<D> Lp) {
        product[i] = way[i] - (dt * lightness[i]) * Lp;
      });
      const double curvature = weighted(backend, f, way, product, lightness);
      const Real alpha = curvature > 0 ? Real(zr / curvature) : 0;
      backend.for_each("viscosity: step", f, [=] FRESHET_LAMBDA(int i) {
        dv[i] += alpha * way[i];
        left[i] += (-alpha) * product[i];
      });
    }
  }
  /// sum_i a_i · b_i/lightness_i
  double weighted(B& backend, const Fluid& f, Field<Vec<D>> a, Field<Vec<D>> b,
                  const PerLiquid& lightness) const {
    return backend.sum("viscosity: sums", f, [=] FRESHET_LAMBDA(int i) {
      return double(dot(a[i], b[i])) / double(lightness[i]);
    });
  }
  /// z · left, with z the preconditioned residual.
  double preconditioned(B& backend, const Fluid& f, const PerLiquid& lightness) const {
    const auto self = z();
    const auto left = left_;
    return backend.sum("viscosity: sums", f, [=] FRESHET_LAMBDA(int i) {
      return double(dot(self(i), left[i])) / double(lightness[i]);
    });
  }
  void step_way(B& backend, const Fluid& f, Real beta) const {
    const auto self = z();
    const auto way = way_;
    backend.for_each("viscosity: step", f, [=] FRESHET_LAMBDA(int i) {
      way[i] = beta > 0 ? self(i) + beta * way[i] : self(i);
    });
  }
  struct Preconditioned {
    Field<Vec<D>> diagonal, off, left;
    FRESHET_HD Vec<D> operator()(int i) const {
      if constexpr (D == 3) return Symmetric<3, Real>{diagonal[i], off[i]} * left[i];
      else return Symmetric<2, Real>{diagonal[i], off[i].x} * left[i];
    }
  };
  Preconditioned z() const { return {diagonal_, off_, left_}; }

 private:
  ForceParameters<D> c_;
  Kernel<D> W_;
  Field<Vec<D>> dv_;                    // kept: of the step before
  Field<Vec<D>> left_, way_, product_;  // scratch
  Field<Vec<D>> diagonal_, off_;        // scratch: the preconditioner
};

}  // namespace FRESHET_ISA
}  // namespace freshet
