// SPDX-License-Identifier: MIT
// The words of the pages in English and Chinese.

const words = {
  article: ['The article', '文章'],
  scenes: ['Scenes', '场景'],
  other: ['中文', 'English'],
  play: ['Run', '运行'],
  pause: ['Pause', '暂停'],
  step: ['One step', '走一步'],
  restart: ['Restart', '重新开始'],
  more: ['More', '更多'],
  picture: ['Save picture', '保存图片'],
  scene_file: ['Save scene', '保存场景'],
  link: ['Copy link', '复制链接'],
  copied: ['Link copied', '链接已复制'],
  saved: ['Saved', '已保存'],
  numbers: ['Numbers', '数值'],
  all_sliders: ['All numbers to change', '所有可改的数'],
  warnings: ['Warnings', '警告'],
  command: ['The same run on the command line', '同样的命令行运行'],
  color: ['Colour', '颜色'],
  look: ['Look', '外观'],
  balls: ['balls', '小球'],
  water: ['water', '水面'],
  slice: ['Slice across', '切片方向'],
  none: ['none', '无'],
  pace: ['Pace', '快慢'],
  real_time: ['real time', '实时'],
  fastest: ['as fast as it goes', '尽快'],
  time: ['time', '时间'],
  steps: ['steps', '步数'],
  rate: ['steps per second', '每秒步数'],
  particles: ['particles', '粒子'],
  density_mean: ['mean density', '平均密度'],
  density_range: ['density, minimum to maximum', '密度范围'],
  density_error: ['density error, mean', '平均密度误差'],
  speed_mean: ['mean speed', '平均速度'],
  speed_max: ['fastest particle', '最快的粒子'],
  height_mean: ['mean height', '平均高度'],
  kinetic_energy: ['kinetic energy', '动能'],
  iterations: ['iterations of the last step', '上一步的迭代次数'],
  dt: ['time step', '时间步长'],
  neighbors: ['neighbours in the lattice', '格点中的邻居数'],
  lattice: ['density of the resting lattice', '静止格点的密度'],
  sound_speed: ['speed of sound', '声速'],
  step_bound: ['bound of the time step', '时间步长上限'],
  mass: ['mass of a particle', '粒子质量'],
  bright: ['bright pixels', '亮像素'],
  bottom_third: ['pixels in the bottom third', '下方三分之一的像素'],
  outside: ['outside the box', '在盒外'],
  limit: ['limit', '局限'],
  remedy: ['remedy', '办法'],
  panels: ['Numbers, warnings and files', '数值、警告和文件'],
  wrong: ['mistake', '错误'],
  right: ['correction', '修正'],
  bits: ['Same bits as on the command line', '与命令行相同的比特'],
  bits_text: ['The article\'s scene, 2000 steps, in this browser. The sums are those of the native program on every processor. The picture is the one that a run writes, pixel for pixel that of the article. The moving view is drawn with WebGL and is not compared.',
    '文章的场景，2000 步，就在这个浏览器里运行。这些校验和与本机程序在任何处理器上的结果相同。图片就是一次运行写出的图片，与文章的图片逐像素相同。活动的画面由 WebGL 绘制，不参与比较。'],
  compare: ['Run and compare', '运行并比较'],
  running: ['Running …', '运行中 ……'],
  same: ['same', '相同'],
  different: ['different', '不同'],
  state_sha: ['state_sha256', 'state_sha256'],
  picture_sha: ['picture, SHA-256 of its pixels', '图片像素的 SHA-256'],
  native: ['native', '本机'],
  here: ['here', '本页'],
  restarted: ['starts anew', '会重新开始'],
  of_end: ['of', '/'],
  orbit: ['Drag to turn, pinch or scroll to zoom', '拖动旋转，双指或滚轮缩放'],
  push: ['Drag to push the water', '拖动推水'],
  pushed: ['pushed by hand', '手动推过'],
  failed: ['The run stopped', '运行中止'],
  keys: ['Keys: space runs and pauses, s takes a step, r restarts, arrows turn the view',
    '按键：空格运行或暂停，s 走一步，r 重新开始，方向键转动视角'],
  speed: ['speed', '速度'],
  velocity_x: ['velocity x', '速度 x'],
  velocity_y: ['velocity y', '速度 y'],
  velocity_z: ['velocity z', '速度 z'],
  density: ['density', '密度'],
  pressure: ['pressure', '压力'],
  height: ['height', '高度'],
  id: ['id', '编号'],
  liquid: ['liquid', '液体'],
  density_error_color: ['density error', '密度误差'],
  edit: ['Edit a scene', '编辑场景'],
  edit_text: ['Choose a bundled scene, change its TOML and run it. Errors and warnings are those of the command.',
    '选一个自带的场景，改它的 TOML 并运行。错误和警告与命令行相同。'],
  choose: ['Bundled scene', '自带的场景'],
  run_scene: ['Run this scene', '运行此场景'],
  solver: ['Solver', '求解器'],
  own_solver: ['of the scene', '场景自己的'],
  resolution: ['Particles', '粒子数'],
  valid: ['Valid', '有效'],
  starting: ['Loading the simulation …', '正在载入模拟 ……'],
  not_here: ['not in the page', '不能在网页里运行'],
  open_here: ['Open in the editor', '在编辑器中打开'],
  legend: ['Contents', '目录'],
  no_webgl: ['This page draws with WebGL2, which this browser does not offer.', '本页用 WebGL2 绘图，而这个浏览器没有。'],
};

export const language = (() => {
  const asked = new URLSearchParams(location.search).get('lang');
  if (asked === 'zh' || asked === 'en') return asked;
  return (navigator.language || 'en').startsWith('zh') ? 'zh' : 'en';
})();

export const word = (key) => words[key]?.[language === 'zh' ? 1 : 0] ?? key;

/** Writes the words of elements that name them: data-word, data-title. */
export function translate(root = document) {
  document.documentElement.lang = language === 'zh' ? 'zh-CN' : 'en';
  root.querySelectorAll('[data-word]').forEach((e) => { e.textContent = word(e.dataset.word); });
  root.querySelectorAll('[data-title]').forEach((e) => {
    e.title = word(e.dataset.title);
    e.setAttribute('aria-label', e.title);
  });
  root.querySelectorAll('[data-other-language]').forEach((e) => {
    e.onclick = () => {
      const address = new URL(location.href);
      address.searchParams.set('lang', language === 'zh' ? 'en' : 'zh');
      location.href = address;
    };
  });
  root.querySelectorAll('a[data-keep]').forEach((e) => {
    const address = new URL(e.getAttribute('href'), location.href);
    address.searchParams.set('lang', language);
    e.href = address;
  });
}
