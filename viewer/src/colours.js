// SPDX-License-Identifier: Apache-2.0
// Colours of the view. All scales can be told apart by people who see few colours: cividis for heights (Nunez, Anderton,
// Renslow 2018), blue-white-orange for signs, and the palette of Okabe and Ito (2008) for classes.

const cividis = [[0, 34, 78], [18, 53, 112], [59, 73, 108], [87, 93, 109], [112, 113, 115], [138, 134, 120], [165, 156, 116],
  [195, 179, 105], [225, 204, 85], [254, 232, 56]];
const signed = [[32, 84, 161], [94, 147, 207], [168, 201, 232], [225, 228, 230], [246, 205, 147], [228, 142, 52], [176, 80, 8]];

// The colour at t in [0, 1] of a list of colours, as bytes.
export function along(list, t) {
  const at = Math.max(0, Math.min(1, t)) * (list.length - 1), i = Math.min(list.length - 2, Math.floor(at)), f = at - i;
  return [0, 1, 2].map((c) => Math.round(list[i][c] + f * (list[i + 1][c] - list[i][c])));
}
export const ofHeight = (t) => along(cividis, t);
export const ofSign = (t) => along(signed, (t + 1) / 2);

// Labels that a run gives: their numbers are those of the extra byte `label`.
export const ofLabel = [[140, 146, 156], [190, 165, 122], [213, 94, 0], [148, 130, 160], [0, 158, 115], [204, 160, 120], [86, 180, 233],
  [0, 114, 178], [240, 228, 66], [204, 121, 167], [43, 108, 176], [230, 159, 0], [197, 48, 48], [90, 122, 60], [26, 54, 110],
  [0, 150, 170], [214, 51, 132], [120, 84, 50], [106, 61, 154], [196, 148, 100], [124, 190, 60], [112, 114, 122], [176, 160, 40]];

// Classes of producers (ASPRS), as far as they are common.
export const ofClass = { 2: [176, 150, 110], 3: [128, 190, 110], 4: [60, 160, 90], 5: [0, 120, 80], 6: [213, 94, 0], 7: [200, 40, 160],
  9: [86, 180, 233], 17: [140, 140, 180], 18: [200, 40, 160], 26: [204, 121, 167] };
export const otherClass = [150, 155, 163];

// One of many colours that depends on a number alone; neighbouring numbers get unlike hues and two lightnesses.
export function ofNumber(number) {
  if (number === 0) return [120, 125, 133];
  const hue = (number * 0.618033988749895) % 1, light = number % 2 ? 0.62 : 0.48, chroma = 0.55;
  const part = (shift) => {
    const k = (shift + hue * 12) % 12, a = chroma * Math.min(light, 1 - light);
    return Math.round(255 * (light - a * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [part(0), part(8), part(4)];
}

// A colour of the page's style, as three numbers from 0 to 255.
export function ofStyle(name) {
  const text = window.ilot.colour(name);
  const hex = text.match(/^#(..)(..)(..)$/);
  return hex ? hex.slice(1).map((part) => parseInt(part, 16)) : [128, 128, 128];
}
