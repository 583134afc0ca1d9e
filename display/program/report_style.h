// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace povpreview {

/// The report's style sheet: one column on a phone, grids where there is room, dark text on white
/// and no page breaks inside figures on paper.
inline constexpr const char* report_style = R"css(
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; color: #222; background: #fff;
  max-width: 76rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .5rem 0; }
h2 { font-size: 1.35rem; border-bottom: 2px solid #ddd; padding-bottom: .2rem; margin: 2rem 0 .8rem; }
h3, h4 { margin: 1.2rem 0 .4rem; }
a { color: #0072b2; }
.scroll { overflow-x: auto; margin: 1rem 0; }
.tables { display: flex; flex-wrap: wrap; gap: 0 2.5rem; }
.tables .scroll { max-width: 100%; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .92rem; }
caption { text-align: left; font-weight: 600; padding-bottom: .3rem; }
th, td { padding: .25rem .7rem; border-bottom: 1px solid #e4e4e4; text-align: right;
  vertical-align: top; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
small { color: #666; font-size: .8em; }
td.win { background: #e3f3ea; }
td.loss { background: #fbe3da; }
td.none { color: #999; }
.failure { background: #fbe3da; padding: .4rem .7rem; }
.losses { columns: 22rem; padding-left: 1.2rem; font-size: .92rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr));
  gap: .8rem; margin: 1rem 0; }
.plots img { width: 100%; height: auto; }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 17rem), 1fr));
  gap: 1rem; }
figure { margin: 0; break-inside: avoid; }
figure img { width: 100%; height: auto; display: block; }
figcaption { font-size: .86rem; line-height: 1.35; margin-bottom: .3rem; }
.crops { display: grid; grid-template-columns: repeat(3, 1fr); gap: 2px; margin-top: 2px; }
img.crop { image-rendering: pixelated; }
.framed { position: relative; }
.framed svg { position: absolute; inset: 0; width: 100%; height: 100%; }
.framed rect { fill: none; stroke: #fff; stroke-width: 2px; vector-effect: non-scaling-stroke;
  outline: 1px solid #000; }
.framed text { fill: #fff; stroke: #000; stroke-width: 3px; paint-order: stroke; font-weight: 700;
  font-size: calc(13 * var(--unit)); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1rem; }
dt { color: #666; }
dd { margin: 0; overflow-wrap: anywhere; }
pre { font-size: .8rem; line-height: 1.35; margin: .3rem 0; }
.notes { font-size: .92rem; padding-left: 1.2rem; }
@media (max-width: 30rem) {
  body { padding: .7rem; font-size: 15px; }
  th, td { padding: .2rem .45rem; }
  dl { grid-template-columns: 1fr; gap: 0; }
  dd { margin-bottom: .5rem; }
}
@media print {
  body { max-width: none; font-size: 10pt; padding: 0; }
  h2, h3, h4, caption { break-after: avoid; }
  section { break-before: page; }
  table, figure, .plots img { break-inside: avoid; }
  .scroll { overflow: visible; }
  th, td { padding: .15rem .4rem; }
  .grid { grid-template-columns: repeat(3, 1fr); }
  .plots { grid-template-columns: 1fr 1fr; }
  td { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
}
)css";

/// What the figures mean, for someone who does not know the program.
inline constexpr const char* report_explanation = R"html(
<p>The finished pictures are complete renders by the stock <code>povray</code>, without
anti-aliasing (one sample for each pixel) and with its own (<code>+A0.3 +AM1 +R3</code>); the
previews are smoothed with four points a pixel for the second. All methods but
<code>stock-mosaic</code> trace with the same patched POV-Ray in a process of its own, started anew
for each run, and all share the same cores with their own work. Pictures are taken at moments of a
geometric schedule; copying, drawing and measuring them is left off the clock.</p>
<p><code>stock-mosaic</code> is the stock <code>povray +SP32 +EP1</code>, with its window off and
its picture going to a file. What it would show is read afterwards from its render state file, to
which it writes each block when it sends it to be displayed. Its parse counts as over when that file
comes; photons and a radiosity pretrace, which it does after that, are in its time and not in that of
the others: compare these by the seconds since launch.</p>
<p>Errors are of display-encoded colour in [0, 1]. <b>L1</b>: mean absolute difference.
<b>FLIP</b>: difference to the eye when both pictures alternate (Andersson et al. 2020, at 67
pixels a degree). <b>SSIM</b>: of luma (Wang et al. 2004). <b>L1 near edges</b>: of pixels within
2 pixels of an edge of the finished picture. An error is reached when it is never exceeded later; the
moment is interpolated between two pictures on logarithmic axes. <b>Memory</b>: the most that the
tracer had, and what the preview took at the schedule's moments. <b>&micro;s each</b>: what a full
ray, a probe and an albedo ray cost a thread of the tracer. The error maps show FLIP from black (0)
over red to light yellow (1). Everything is in <code>curves.csv</code>; every figure here and in
<code>summary.json</code> follows from it.</p>
)html";

}  // namespace povpreview
