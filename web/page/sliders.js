// SPDX-License-Identifier: MIT
// The numbers that sliders change: the key of the scene, its range and the present value in what a
// session says of its scene.

const digits = (v) => String(Number(v.toPrecision(3)));

export const sliders = {
  k: {
    symbol: 'k', key: 'solver.stiffness', min: 5, max: 10000, log: true, unit: 'm²/s²',
    en: 'stiffness', zh: '刚度', from: (a) => a.stiffness, to: digits,
    suits: (a) => a.solver === 'mueller2003',
  },
  mu: {
    symbol: 'μ', key: 'fluid.viscosity', min: 0.001, max: 100, log: true, unit: 'Pa s',
    en: 'viscosity', zh: '粘度', from: (a) => a.viscosity, to: digits, suits: () => true,
  },
  h: {
    symbol: 'h', key: 'particles.support_radius', min: 1.05, max: 3.5, unit: 'm',
    en: 'support radius', zh: '支撑半径', from: (a) => a.support, to: digits, suits: () => true,
    relative: (a) => a.spacing,
  },
  dt: {
    symbol: 'Δt', key: 'time.step', min: 0.0001, max: 0.02, log: true, unit: 's',
    en: 'time step', zh: '时间步长', from: (a) => a.step || a.step_bound, to: digits,
    suits: (a) => a.step > 0,
  },
  gravity: {
    symbol: 'g', key: 'domain.gravity', min: 0, max: 25, unit: 'm/s²',
    en: 'gravity', zh: '重力', from: (a) => -(a.gravity[1] ?? -9.81),
    to: (v, a) => (a.dimension === 3 ? `[0.0, ${-digits(v)}, 0.0]` : `[0.0, ${-digits(v)}]`),
    suits: () => true,
  },
  restitution: {
    symbol: 'e', key: 'walls.restitution', min: 0, max: 1, unit: '',
    en: 'restitution', zh: '恢复系数', from: (a) => a.restitution, to: digits,
    suits: (a) => a.solver === 'mueller2003',
  },
  count: {
    symbol: 'N', key: 'fluid.count', min: 4, max: 40, step: 1, unit: '',
    en: 'particles', zh: '粒子数', from: (a) => a.count?.[1], to: (v) => `[24, ${Math.round(v)}]`,
    shown: (v) => 24 * Math.round(v), suits: (a) => a.count?.length === 2, restart: true,
  },
};

/** The position of a slider, 0 to 1, of a value, and back. */
export function positionOf(slider, about, value) {
  const unit = slider.relative?.(about) ?? 1;
  const [low, high, v] = [slider.min, slider.max, value / unit];
  return slider.log ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low);
}

export function valueAt(slider, about, position) {
  const unit = slider.relative?.(about) ?? 1;
  const { min, max } = slider;
  return unit * (slider.log ? min * (max / min) ** position : min + (max - min) * position);
}
