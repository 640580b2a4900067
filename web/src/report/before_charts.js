// SPDX-License-Identifier: BSD-3-Clause
// What uPlot finds when it starts: at least two pixels of a chart for each of the page, so that print is sharp, and its style.
import chartStyle from 'uplot/dist/uPlot.min.css';

window.devicePixelRatio = Math.max(2, window.devicePixelRatio);
const style = document.createElement('style');
style.textContent = chartStyle;
document.head.prepend(style);  // before the style of the report, which changes it
