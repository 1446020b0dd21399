// SPDX-License-Identifier: MIT
// The experiments beside the article's text: by the number of the section in docs/article.md (the
// same in both languages). A run is a bundled scene, perhaps another solver, and changed keys; a key
// with null is removed. `try` says what to look at.

const paper = { 'solver.scheme': '"paper"', 'particles.mass': null, 'solver.speed_limit': null };
const fits = { 'fluid.count': '[24, 17]', 'fluid.outside': null };
const quiet = { 'output.frame_every_steps': null, checks: null };
const water = { ...quiet, 'fluid.viscosity': '0.001', 'time.step': '"adaptive"', 'time.step_max': '0.002' };

export const runs = {
  article: { scene: 'article', en: 'The article\'s run', zh: '文章的模拟' },
  h2: {
    scene: 'article', changes: {}, mark: 'wrong',
    en: 'h = 0.2: 4 neighbours', zh: 'h = 0.2：4 个邻居',
  },
  h3: {
    scene: 'article', changes: { 'particles.support_radius': '0.3' }, mark: 'right',
    en: 'h = 0.3: 12 neighbours', zh: 'h = 0.3：12 个邻居',
  },
  spiky10: { scene: 'article', changes: {}, mark: 'wrong', en: 'Factor −10', zh: '系数 −10' },
  spiky30: {
    scene: 'article', changes: paper, mark: 'right', en: 'Factor −30: the paper\'s scheme', zh: '系数 −30：论文的格式',
  },
  euler: {
    scene: 'article', changes: { ...paper, ...fits, 'time.integrator': '"symplectic_euler"' }, mark: 'wrong',
    en: 'One kick, one drift', zh: '踢一步、漂一步',
  },
  leapfrog: {
    scene: 'article', changes: { ...paper, ...fits, 'time.integrator': '"leapfrog"' }, mark: 'right',
    en: 'Half kick, drift, half kick', zh: '半踢、漂、半踢',
  },
  half: { scene: 'article', changes: {}, mark: 'wrong', en: 'Factor 0.5: loses 75 %', zh: '系数 0.5：损失 75 %' },
  root: {
    scene: 'article', changes: { 'walls.restitution': '0.7071' }, mark: 'right',
    en: 'Factor √0.5: loses 50 %', zh: '系数 √0.5：损失 50 %',
  },
  boiling: {
    scene: 'article', changes: { 'solver.stiffness': '5000', 'time.step': '0.005', checks: null }, mark: 'wrong',
    en: 'k = 5000, Δt = 0.005: boils', zh: 'k = 5000，Δt = 0.005：沸腾',
  },
  calm: {
    scene: 'article', changes: { 'solver.stiffness': '5000', 'time.step': '0.0005' }, mark: 'right',
    en: 'k = 5000, Δt = 0.0005: comes to rest', zh: 'k = 5000，Δt = 0.0005：静下来',
  },
  restless: {
    scene: 'article', changes: { 'time.step': '0.015', 'time.end': '4', checks: null }, mark: 'wrong',
    en: 'Δt = 0.015: keeps bubbling', zh: 'Δt = 0.015：一直冒泡',
  },
  light: { scene: 'article', changes: {}, mark: 'wrong', en: 'Mass 0.02: density 0.85', zh: '质量 0.02：密度 0.85' },
  heavy: {
    scene: 'article', changes: { 'particles.mass': '22.5', 'fluid.rest_density': '1000' }, mark: 'right',
    en: 'Mass 22.5: density 956', zh: '质量 22.5：密度 956',
  },
  dots5: { scene: 'article', changes: {}, mark: 'wrong', en: 'Dots of 5 px: 6.4 %', zh: '点的半径 5 像素：6.4 %' },
  dots1: {
    scene: 'article', changes: { 'picture.dot_radius': '1' }, mark: 'right', en: 'Dots of 1 px: 0.8 %',
    zh: '点的半径 1 像素：0.8 %',
  },
  stiff: {
    scene: 'article', changes: { 'solver.stiffness': '5880', 'time.step': '0.0005' }, mark: 'right',
    en: 'k = 5880: compressed by about 1 %', zh: 'k = 5880：压缩约 1 %',
  },
  pairs: {
    scene: 'article', changes: { 'solver.search': '"all_pairs"' }, mark: 'limit', en: 'All pairs', zh: '比较所有的粒子对',
  },
  grid: { scene: 'article', changes: { 'solver.search': '"grid"' }, mark: 'remedy', en: 'Grid search', zh: '网格搜索' },
  collide: {
    scene: 'article_corrected', changes: quiet, mark: 'limit', en: 'Walls that only collide', zh: '只会碰撞的壁面',
  },
  walls: {
    scene: 'article_corrected', solver: 'wcsph', changes: quiet, mark: 'remedy', en: 'Real walls: wcsph',
    zh: '真正的壁面：wcsph',
  },
  pcisph: { scene: 'article_corrected', solver: 'pcisph', changes: water, en: 'pcisph', zh: 'pcisph' },
  iisph: { scene: 'article_corrected', solver: 'iisph', changes: water, en: 'iisph', zh: 'iisph' },
  dfsph: { scene: 'article_corrected', solver: 'dfsph', changes: water, en: 'dfsph', zh: 'dfsph' },
  pbf: { scene: 'article_corrected', solver: 'pbf', changes: water, en: 'pbf', zh: 'pbf' },
  deep: {
    scene: 'dam_break_3d', solver: 'dfsph', en: 'A dam break in 3D', zh: '三维溃坝',
    changes: { checks: null, 'particles.spacing': '0.04', 'particles.support_radius': '0.1' },
  },
  block25: { scene: 'article', changes: {}, mark: 'wrong', en: '25 rows: higher than the box', zh: '25 行：比盒子高' },
  block17: {
    scene: 'article', changes: { 'fluid.count': '[24, 17]' }, mark: 'right', en: '17 rows: the block fits',
    zh: '17 行：放得下',
  },
  stiffer: {
    scene: 'article', changes: { 'solver.stiffness': '500' }, mark: 'right', en: 'k = 500: density 0.92',
    zh: 'k = 500：密度 0.92',
  },
  corrected: { scene: 'article_corrected', changes: quiet, mark: 'right', en: 'The corrected scene', zh: '修正后的场景' },
};

/** Cards by section: sliders, runs and what to look at. `after` is the number of the block that the
    card follows; without it the card ends the section. */
export const cards = {
  0: { runs: ['article'], sliders: ['k', 'mu', 'h', 'dt', 'gravity', 'count'], digest: true, after: 2,
    en: 'The article\'s 600 particles run on this page. Move a number and watch what changes. Push the water with the pointer.',
    zh: '文章的 600 个粒子就在本页运行。改一个数，看看有什么变化。可以用指针推动水。' },
  2: { runs: ['article'], sliders: ['gravity', 'count'],
    en: 'The weight and the number of particles.', zh: '重力和粒子数。' },
  4: { runs: ['h2', 'h3'], sliders: ['h'], shown: ['neighbors', 'lattice'],
    en: 'The density of the resting lattice comes from the number of neighbours.',
    zh: '静止格点上的密度取决于邻居的个数。' },
  5: { runs: ['spiky10', 'spiky30'], sliders: [], shown: ['density_mean'],
    en: 'Three times the pressure forces push the fluid apart: compare the mean density at the end.',
    zh: '压力梯度力变为三倍，流体被推开：比较最后的平均密度。' },
  6: { runs: [], sliders: ['mu'], shown: ['kinetic_energy'],
    en: 'More viscosity stops the motion sooner.', zh: '粘度越大，运动停得越快。' },
  8: { runs: [], sliders: ['k'], shown: ['density_mean', 'sound_speed'],
    en: 'A stiffer fluid is compressed less, and its sound is faster.', zh: '刚度越大，流体压缩得越少，声速越高。' },
  11: { runs: ['euler', 'leapfrog'], sliders: ['dt'], shown: ['kinetic_energy'],
    en: 'Both cost the same. At a fine step they look alike; the second is of second order.',
    zh: '两者代价相同。步长很小时看上去一样；第二种是二阶精度。' },
  12: { runs: ['half', 'root'], sliders: ['restitution'], shown: ['kinetic_energy'],
    en: 'Watch the energy when the block hits the floor.', zh: '看方块碰到地面时的能量。' },
  13: { runs: ['boiling', 'calm', 'restless'], sliders: ['dt', 'k'], shown: ['step_bound', 'kinetic_energy'],
    en: 'Above the bound of sound the water boils, although h/v is far larger.',
    zh: '超过声速给出的上限，水就沸腾，尽管 h/v 大得多。' },
  14: { runs: ['light', 'heavy'], sliders: [], shown: ['lattice', 'mass'],
    en: 'The number changes with the mass, in the same units.', zh: '单位相同，数值随质量而变。' },
  15: { runs: [], sliders: [], colors: true, en: 'Colour by another quantity.', zh: '用别的量着色。' },
  16: { runs: ['dots5', 'dots1', 'stiff'], sliders: ['k'], shown: ['bright', 'step_bound'],
    en: 'The bright pixels follow from the dots. The particles are the same.', zh: '亮像素取决于点的大小，粒子并没有变。' },
  17: { runs: ['pairs', 'grid', 'collide', 'walls', 'pcisph', 'iisph', 'dfsph', 'pbf', 'deep'], sliders: [],
    shown: ['rate', 'density_error', 'iterations'],
    en: 'The article\'s next steps, live. Grid and pairs give the same bits. Look at the steps per second, the line of particles along the floor, and the density error.',
    zh: '文章的下一步，就在这里。网格与全部比较得到相同的比特。看每秒步数、沿地面的那一行粒子和密度误差。' },
  18: { runs: ['block25', 'block17', 'stiffer'], sliders: ['count', 'k'], shown: ['density_mean', 'bottom_third'], digest: true,
    en: 'The article\'s five figures come from this run.', zh: '文章的五个数字来自这次模拟。' },
  20: { runs: ['corrected'], sliders: ['k', 'mu', 'h', 'dt'], shown: ['density_mean', 'density_error'],
    en: 'A column of water falls, sloshes and settles flat.', zh: '一柱水落下、晃荡，最后平静下来。' },
};
