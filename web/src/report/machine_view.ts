// SPDX-License-Identifier: BSD-3-Clause
// The machine of a report in 3D with its modes and operating shapes, drawn and moved by the code of the page, from data in
// the report (src/trivet/report/page/machine_json.h).
import {html, nothing, render} from 'lit/html.js';
import {DARK, LIGHT} from '../machine/colours.ts';
import {MachineScene} from '../machine/machine_scene.ts';
import {ALONE, Stage, type View} from '../machine/stage.ts';
import {TURNS} from '../machine_keys.ts';
import {ofMode, ofRoot, ofShape, sizeWords, type Motion, type MovingModes, type MovingRoots} from '../motion.ts';
import {number} from '../quantities.ts';
import type {Scene, Shapes} from '../results.ts';
import {scenesOf, type StoredScenes} from './stored_scenes.ts';
import sheetOfView from './machine_view.css';

interface MachineOfReport extends StoredScenes {
  frequency: {unit: string; factor: number};  // from rad/s
  cases: CaseOfReport[];
}
interface CaseOfReport {
  name: string;
  scene: number;  // its place in the list
  modes: MovingModes & {all: number};
  roots: MovingRoots | null;
  shapes: OperatingShapes | null;
}
/// Those at the speeds of the machine have words for it.
interface OperatingShapes {
  all: number;
  shapes: (Shapes['shapes'][number] & {at?: string})[];
}
interface Choice {
  words: string;
  motion: Motion | null;  // null: at rest
}
const VIEWS: readonly View[] = ['oblique', 'front', 'side', 'top'];
const TURN = 2 * Math.PI;

class MachineView {
  private readonly stage: Stage;
  private readonly canvas: HTMLCanvasElement;
  private readonly dark = matchMedia('(prefers-color-scheme: dark)');
  private readonly scenes: readonly Scene[];
  private scene: Scene | null = null;
  private machine: MachineScene | null = null;
  private choices: Choice[] = [];
  private shown = {case: 0, motion: 0};
  private damped = false;
  private playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  private share = 0.04;  // largest drawn displacement over the size of the machine
  private speed = 0.5;  // drawn periods a second
  private phase = 0;  // [rad]
  private scale = 0;
  private last = 0;
  private isSeen = true;

  constructor(private readonly holder: HTMLElement, private readonly data: MachineOfReport) {
    this.scenes = scenesOf(data);
    this.render();
    this.canvas = holder.querySelector('canvas')!;
    this.stage = new Stage(this.canvas, this.colours.background, () => this.frame());
    this.letThePageScroll();
    // The report sets the ratio of its page to 2 or more, for charts on paper.
    this.stage.renderer.setPixelRatio(matchMedia('(min-resolution: 1.5dppx)').matches ? 2 : 1);
    const fit = () => this.stage.resize(this.canvas.clientWidth, this.canvas.clientHeight);
    new ResizeObserver(fit).observe(this.canvas.parentElement!);
    new IntersectionObserver(entries => {
      this.isSeen = entries.at(-1)!.isIntersecting;
      if (this.isSeen) this.stage.draw();
    }).observe(this.canvas);
    this.dark.addEventListener('change', () => this.build(false));
    fit();
    this.showCase(0);
  }

  private get colours() { return this.dark.matches ? DARK : LIGHT; }
  private get motion() { return this.choices[this.shown.motion]?.motion ?? null; }
  private get words() {
    const {motion, machine, scale} = this, size = motion && machine ? sizeWords(motion, machine.scene.bodies, scale) : '';
    return [this.choices[this.shown.motion]?.words, size].filter(Boolean).join(' · ');
  }

  /// Over the canvas the wheel scrolls the page, and with Ctrl it zooms, as in the charts; a finger scrolls up and down.
  private letThePageScroll() {
    this.canvas.style.touchAction = 'pan-y';
    const forThePage = (event: WheelEvent) => { if (!event.ctrlKey) event.stopPropagation(); };
    this.canvas.parentElement!.addEventListener('wheel', forThePage, {capture: true, passive: true});
  }
  private showCase(index: number) {
    const scene = this.scenes[this.data.cases[index]!.scene]!, isNew = scene !== this.scene;
    this.scene = scene;
    this.shown.case = index;
    this.choices = this.choicesOf(this.data.cases[index]!, scene);
    this.shown.motion = Math.max(this.choices.findIndex(({motion}) => motion && motion.angular_frequency > 0), 0);
    if (isNew) this.build(this.machine === null || this.machine.scene.title !== scene.title);
    this.changed();
  }
  private choicesOf({modes, roots, shapes}: CaseOfReport, {bodies}: Scene): Choice[] {
    const {unit, factor} = this.data.frequency;
    const frequency = (omega: number | null) => (omega === null ? 'unstable' : `${number(omega * factor)} ${unit}`);
    const ofModes = modes.modes.map((mode, i) => {
      const decaying = this.damped && roots ? ofRoot(roots, mode.number, bodies) : null, motion = decaying ?? ofMode(modes, i, bodies);
      const label = decaying?.label ?? `Mode ${mode.number}`, omega = decaying?.angular_frequency ?? mode.angular_frequency;
      return {words: `${label}: ${frequency(omega)}, ${mode.name}`, motion};
    });
    const ofShapes = (shapes?.shapes ?? []).map(shape => ({
      words: `Operating shape at ${shape.at ? `${shape.at}: ` : ''}${frequency(shape.angular_frequency)}`,
      motion: ofShape({shapes: [shape]}, bodies)}));
    return [...ofModes, ...ofShapes, {words: 'At rest', motion: null}];
  }
  private build(fit: boolean) {
    this.machine = new MachineScene(this.scene!, this.colours);
    this.stage.show(this.machine, this.colours, fit);
    this.changed();
  }
  private changed() {
    this.scale = this.motion && this.machine ? this.machine.scaleFor(this.motion, this.share) : 0;
    this.render();
    this.stage.draw();
  }
  /// Brings the machine to the present phase, and asks for the next picture while it plays in the window.
  private frame() {
    if (!this.machine) return;
    const now = performance.now(), step = Math.min((now - this.last) / 1000, 0.1);
    this.last = now;
    if (this.playing && this.isSeen && this.motion) {
      this.phase = (this.phase + TURN * this.speed * step) % TURN;
      this.stage.drawWhenFree(ALONE);
    }
    this.machine.move(this.motion, this.phase, this.scale);
  }

  /// What of a case is not here.
  private notes(): string {
    const {modes, shapes} = this.data.cases[this.shown.case]!;
    const missing = ({length}: readonly unknown[], all: number, what: string) =>
      (length < all ? ` Here are the first ${length} of ${all} ${what}.` : '');
    return missing(modes.modes, modes.all, 'modes') + (shapes ? missing(shapes.shapes, shapes.all, 'operating shapes') : '');
  }
  private render() {
    const {playing, words, data: {cases}} = this;
    const label = `Machine in 3D. ${words}. Arrow keys turn it, plus and minus zoom, Home shows all, space plays or stops, n and p choose ` +
      'the next and the previous motion.';
    render(html`
      <div class="window"><div class="stage" tabindex="0" role="application" aria-label=${label} @keydown=${(event: KeyboardEvent) => this.key(event)}>
        <canvas aria-hidden="true"></canvas></div>
        <p class="shown" role="status">${words}</p></div>
      <div class="bar">
        <button type="button" class="play" @click=${() => this.play()}>
          <span aria-hidden="true">${playing ? '❚❚' : '▶'}</span> ${playing ? 'Stop' : 'Move'}</button>
        ${cases.length > 1 ? list('Case in 3D', '', cases.map(({name}) => name), this.shown.case, index => this.showCase(index)) : nothing}
        ${list('Motion', 'motion', this.choices.map(choice => choice.words), this.shown.motion, index => this.choose(index))}
      </div>
      <div class="bar">
        <span class="views" role="group" aria-label="View">
          ${VIEWS.map(view => html`<button type="button" @click=${() => this.stage.look(view)}>${view}</button>`)}</span>
        ${cases[this.shown.case]!.roots ? html`<label class="damped"><input type="checkbox" .checked=${this.damped}
          @change=${() => this.switchDamping()}> damped</label>` : nothing}
        ${this.slider('Size', 0.01, 0.2, 0.005, this.share, share => { this.share = share; })}
        ${this.slider('Speed', 0.1, 2, 0.1, this.speed, speed => { this.speed = speed; })}
      </div>
      <p class="hint">Drag to turn, turn the wheel with Ctrl to zoom. With keys: arrows, + and −, Home; space moves and stops, n and p choose
        the motion. Motions are enlarged; a mode has no size of its own.${this.notes()}</p>`, this.holder);
  }
  private slider(name: string, min: number, max: number, step: number, value: number, set: (value: number) => void) {
    const change = (event: Event) => {
      set(Number((event.target as HTMLInputElement).value));
      this.changed();
    };
    return html`<label>${name} <input type="range" min=${min} max=${max} step=${step} .value=${String(value)} @input=${change}></label>`;
  }
  private play() {
    this.playing = !this.playing;
    this.changed();
  }
  private switchDamping() {
    this.damped = !this.damped;
    this.choices = this.choicesOf(this.data.cases[this.shown.case]!, this.scene!);
    this.changed();
  }
  private choose(motion: number) {
    this.shown.motion = Math.min(Math.max(motion, 0), this.choices.length - 1);
    this.changed();
  }
  private key(event: KeyboardEvent) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = TURNS[event.key];
    if (turn) this.stage.turn(...turn);
    else if (event.key === 'Home') this.stage.look('oblique');
    else if (event.key === ' ') this.play();
    else if (event.key === 'n') this.choose(this.shown.motion + 1);
    else if (event.key === 'p') this.choose(this.shown.motion - 1);
    else return;
    event.preventDefault();
  }
}

/// A list to choose from.
function list(label: string, style: string, words: readonly string[], chosen: number, choose: (index: number) => void) {
  const change = (event: Event) => choose(Number((event.target as HTMLSelectElement).value));
  return html`<select aria-label=${label} class=${style} @change=${change}>
    ${words.map((one, i) => html`<option value=${i} .selected=${i === chosen}>${one}</option>`)}</select>`;
}

/// Fills the place of the machine in a report, which has the view as a property, as an element of the page has its stage.
export function show(holder: HTMLElement, data: unknown) {
  const sheet = document.createElement('style');
  sheet.textContent = sheetOfView;
  document.head.append(sheet);
  Object.assign(holder, {view: new MachineView(holder, data as MachineOfReport)});
}
globalThis.trivetMachine = {show};
