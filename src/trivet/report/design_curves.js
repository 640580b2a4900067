// SPDX-License-Identifier: BSD-3-Clause
// Curves of one design of a map from its poles and residues, which the program stored: see study/map/curve_fractions.h.

const unpacked = (text, Numbers) => new Numbers(Uint8Array.from(atob(text), sign => sign.charCodeAt(0)).buffer);

/// The stored designs with their numbers in arrays.
function readDesigns(map) {
  const read = {...map, margins: unpacked(map.margins, Float32Array), governing: unpacked(map.governing, Uint8Array)};
  if (map.curves) {
    const {drawn, denominators, numerators, rounded} = map.curves;
    read.curves = {...map.curves, drawn: unpacked(drawn, Uint8Array),
                   denominators: unpacked(denominators, Float64Array),
                   numerators: unpacked(numerators, rounded ? Float32Array : Float64Array)};
  }
  return read;
}

/// Values [re, im, re, im, …] of all curves of a design at ω: Σ (a + b s)/(p + q s + s²) over the pairs of poles, plus
/// powers of s, times e^{−s d} for each delay d; s = iω.
function designAt({pairs, powers, delays, real, results, denominators, numerators}, design, w) {
  const terms = 2 * pairs + powers.length, parts = real ? 1 : 2, basis = new Float64Array(2 * terms);
  const part = (list, k, imaginary) => (imaginary && real ? 0 : list[k * parts + imaginary]);
  for (let k = 0, at = design * 2 * pairs; k < pairs; k++, at += 2) {
    const re = part(denominators, at, 0) - w * w - w * part(denominators, at + 1, 1);
    const im = part(denominators, at, 1) + w * part(denominators, at + 1, 0), size = re * re + im * im;
    const [x, y] = [re / size, -im / size];
    basis.set([x, y, -w * y, w * x], 4 * k);
  }
  powers.forEach((m, j) => {
    const turn = ((m % 4) + 4) % 4, size = w ** m;  // s^m = i^m ω^m
    basis.set([[size, 0], [0, size], [-size, 0], [0, -size]][turn], 2 * (2 * pairs + j));
  });
  const result = new Float64Array(2 * results.length);
  let at = design * delays.length * results.length * terms;
  for (const delay of delays) {
    const cos = Math.cos(w * delay), sin = -Math.sin(w * delay);
    for (let c = 0; c < results.length; c++) {
      let x = 0, y = 0;
      for (let t = 0; t < terms; t++, at++) {
        const a = part(numerators, at, 0), b = part(numerators, at, 1);
        if (a === 0 && b === 0) continue;
        x += a * basis[2 * t] - b * basis[2 * t + 1];
        y += a * basis[2 * t + 1] + b * basis[2 * t];
      }
      result[2 * c] += cos * x - sin * y;
      result[2 * c + 1] += cos * y + sin * x;
    }
  }
  return result;
}

/// Frequencies of the resonances of a design: √|p| of each pair of poles, and where p + q s + s² is least.
function resonancesOf({pairs, real, denominators}, design, [from, to]) {
  const parts = real ? 1 : 2, found = [];
  for (let k = 0, at = design * 2 * pairs * parts; k < pairs; k++, at += 2 * parts) {
    const p = denominators[at], q = denominators[at + parts];
    found.push(Math.sqrt(Math.abs(p)), Math.sqrt(Math.max(0, p - q * q / 2)));
  }
  return found.filter(w => w > from && w < to);
}

/// The maximum of a curve between two frequencies around its highest drawn point, by golden sections.
function maximumBetween(size, from, to) {
  const share = (Math.sqrt(5) - 1) / 2;
  let [a, b] = [from, to], c = b - share * (b - a), d = a + share * (b - a), [fc, fd] = [size(c), size(d)];
  while (b - a > 1e-9 * b) {
    if (fc > fd) [b, d, fd] = [d, c, fc], c = b - share * (b - a), fc = size(c);
    else [a, c, fc] = [c, d, fd], d = a + share * (b - a), fd = size(d);
  }
  return (a + b) / 2;
}

/// How far a drawn maximum rises above the higher of the minima beside it, over its height.
function riseOf(sizes, at) {
  const lowest = step => {
    let least = sizes[at];
    for (let i = at + step; i >= 0 && i < sizes.length && sizes[i] <= sizes[at]; i += step)
      if (sizes[i] < least) least = sizes[i];
    return least;
  };
  return 1 - Math.max(lowest(-1), lowest(1)) / sizes[at];
}

/// A case of the page in which the response is that of a design. `limits` are those of the map.
function caseOfDesign(of, map, design) {
  const {curves} = map, visible = 1e-3;
  const results = curves.results.map(r => ({...r, extrema: [], first_phase: null}));
  const at = w => designAt(curves, design, w), {band} = curves;
  const made = {...of, peaks: [], modes: [], limits: map.limits};
  /// Adds the maxima to the drawn points, and to the peaks of the case.
  const completed = points => {
    const more = [];
    results.forEach((r, c) => {
      if ((of.vanishing ?? []).some(v => same(v, r))) return;
      const sizes = points.map(({v}) => Math.hypot(v[2 * c], v[2 * c + 1])), top = largestOf(sizes);
      for (let i = 1; i + 1 < sizes.length; i++) {
        if (!(sizes[i] > sizes[i - 1] && sizes[i] >= sizes[i + 1] && sizes[i] > 1e-6 * top)) continue;
        if (riseOf(sizes, i) < visible) continue;
        const size = w => { const v = at(w); return Math.hypot(v[2 * c], v[2 * c + 1]); };
        const w = maximumBetween(size, points[i - 1].w, points[i + 1].w), amplitude = size(w) * factorOf(r.unit);
        more.push({w, v: at(w)});
        made.peaks.push({...r, angular_frequency: w, amplitude, unbounded: false, ratio_to_static: null});
      }
    });
    return [...points, ...more].sort((a, b) => a.w - b.w).filter(({w}, i, all) => i === 0 || w > all[i - 1].w);
  };
  made.response = {results, band, at, completed, undefined_at: [], continuous_phase: false,
                   pieces: [{band, nodes: resonancesOf(curves, design, band)}]};
  return made;
}
