// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {colourLegend} from './colour_legend.ts';
import {download} from './download.ts';
import {hasSomethingToJudge} from './judgement.ts';
import {DARK, LIGHT} from './machine/colours.ts';
import {GHOSTS, type Ghost} from './machine/ghosts.ts';
import {labelledPicture} from './machine/labelled_picture.ts';
import {MachineScene} from './machine/machine_scene.ts';
import {markedPoles} from './machine/marks.ts';
import {ALONE, BESIDE_NUMBERS, Stage, type View} from './machine/stage.ts';
import {sizeWords, type Motion} from './motion.ts';
import {COLOURINGS, mountValues, type Colouring} from './mount_colouring.ts';
import {Part} from './part.ts';
import {frequency} from './quantities.ts';
import type {Check, Modes, Scene, SceneBody, Steady, Verdict} from './results.ts';
import {screwOf, screwWords, type PlacedScrew} from './screws.ts';
import {ShownMotion} from './shown_motion.ts';
import {outdatedNote} from './outdated_note.ts';
import {missingSteady, steadyChoices} from './steady_motions.ts';
import {canRecord, framesOf, periodVideo} from './video/period_video.ts';
import {machineKeys} from './machine_keys.ts';

/// The machine in 3D: one selects in it, and modes and operating shapes move.
export class MachineView extends Part {
  private stage: Stage | null = null;
  private machine: MachineScene | null = null;
  private drawn: {scene: Scene | null; key: string} = {scene: null, key: ''};
  private readonly shownMotion = new ShownMotion();
  private sized: unknown[] = [];
  private traced: unknown[] = [];
  private marked: unknown[] = [];
  private pictured: {hand: unknown[]; numbers: unknown[]} = {hand: [], numbers: []};
  private fitted: string | null = null;  // title of the machine that the camera was set for
  private motion: Motion | null = null;
  private scale = 0;
  private last = 0;
  private watcher: ResizeObserver | null = null;
  private hovered = '';
  private recording = false;  // of a video is under way

  override render() {
    const {display, asker, state} = this.app, modes = asker.result<Modes>('modes');
    const {shown} = display, steady = steadyChoices(asker.result<Steady>('steady'), display);
    const chosen = shown.kind === 'mode' ? `${shown.number}` : shown.kind === 'steady' ? `steady ${shown.motion}` : shown.kind;
    const label = this.label(), [screw, body] = this.screw(), command = shown.kind === 'steady' ? 'steady' : shown.kind === 'frequency' ? 'shapes' : 'modes';
    const views: View[] = ['oblique', 'front', 'side', 'top'];
    return html`
      <div class="stage ${asker.isOutdated('scene') ? 'outdated' : ''}" tabindex="0" role="application" aria-label="Machine in 3D: ${label}. Arrow keys turn it, plus and minus zoom, space plays or stops, n and p show the next and the previous mode, s selects the next part."
           @keydown=${(event: KeyboardEvent) => machineKeys(event, this.app, this.stage)}>
        <canvas class="machine" @pointerdown=${this.pressed} @pointerup=${this.released} @pointermove=${this.moved}></canvas>
        <div class="caption" aria-hidden="true">${label}${asker.isOld(command) ? html` <span class="old">…</span>` : nothing}</div>
        ${asker.isOutdated('scene') ? outdatedNote : nothing}
        ${this.legend()}
        ${this.poleLegend()}
        <div class="hover" aria-hidden="true">${this.hovered || state.selection?.name || ''}${screw && !this.hovered ? html` · ${screwWords(screw, body)}` : nothing}</div>
        ${asker.result<Scene>('scene') ? nothing : html`<p class="missing">${asker.missing('scene')}</p>`}
      </div>
      <div class="bar">
        <button class="play" aria-pressed=${display.playing} title="Play or stop (space)" @click=${() => display.set({playing: !display.playing})}>
          ${display.playing ? '❚❚' : '▶'}<span class="hidden">${display.playing ? 'Stop' : 'Play'}</span></button>
        <select aria-label="Motion" .value=${chosen} @change=${this.choose}>
          ${modes?.modes.map(m => html`<option value=${m.number} ?selected=${chosen === `${m.number}`}>${m.number} · ${frequency(m.angular_frequency, display.frequencyUnit)} · ${m.name}</option>`)}
          ${'omega' in shown ? html`<option value="frequency" ?selected=${chosen === 'frequency'}>operating shape at ${frequency(shown.omega, display.frequencyUnit)}</option>` : nothing}
          ${steady.map(s => html`<option value="steady ${s.motion}" ?selected=${chosen === `steady ${s.motion}`}>${s.words}</option>`)}
          <option value="rest" ?selected=${chosen === 'rest'}>at rest</option>
        </select>
      </div>
      <div class="bar">
        <span class="views" role="group" aria-label="View">${views.map(v => html`<button @click=${() => this.stage?.look(v)}>${v}</button>`)}</span>
        <button title="Save the picture as PNG" @click=${this.savePicture}>PNG</button>
        <button title=${canRecord() ? 'Save a video of exactly one period (WebM)' : 'This browser cannot encode videos (WebCodecs)'} ?disabled=${!canRecord() || !this.motion || this.recording}
          @click=${this.saveVideo}>Video</button>
        <label><input type="checkbox" .checked=${display.damped} @change=${(e: Event) => { display.set({damped: (e.target as HTMLInputElement).checked}); asker.again(); }}> damped</label>
        <label><input type="checkbox" .checked=${display.traces} @change=${(e: Event) => display.set({traces: (e.target as HTMLInputElement).checked})}> trace</label>
      </div>
      <div class="bar">
        ${this.slider('Size', 0.01, 0.2, 0.005, display.share, share => display.set({share}))}
        ${this.slider('Speed', 0.1, 2, 0.1, display.speed, speed => display.set({speed}))}
        ${this.slider('Phase', 0, 360, 1, display.phase * 180 / Math.PI, degrees => display.set({phase: degrees * Math.PI / 180, playing: false}))}
      </div>
      <div class="bar">
        <label class="chosen">against <select aria-label="Motion against" @change=${(e: Event) => display.set({ghost: (e.target as HTMLSelectElement).value as Ghost})}>
          ${Object.entries(GHOSTS).map(([key, words]) => html`<option value=${key} ?selected=${key === display.ghost}>${words}</option>`)}</select></label>
        <label class="chosen">mounts <select aria-label="Colour of mounts" @change=${(e: Event) => display.set({colouring: (e.target as HTMLSelectElement).value as Colouring})}>
          ${Object.entries(COLOURINGS).map(([key, words]) => html`<option value=${key} ?selected=${key === display.colouring}>${words}</option>`)}</select></label>
      </div>`;
  }
  /// What is shown: the motion with its frequency.
  private label(): string {
    const {display: {shown, frequencyUnit, share}, asker} = this.app, {motion} = this;
    if (!motion) return shown.kind === 'steady' ? missingSteady(asker, shown.omega) : 'at rest';
    const named = `${motion.label}, ${frequency(motion.angular_frequency, frequencyUnit)}${motion.words ? `: ${motion.words}` : ''}`;
    const size = this.machine ? sizeWords(motion, this.machine.scene.bodies, this.machine.scaleFor(motion, share)) : '';
    return size ? `${named} · ${size}` : named;
  }
  override firstUpdated() {
    const canvas = this.querySelector('canvas')!;
    this.stage = new Stage(canvas, (this.app.display.theme === 'dark' ? DARK : LIGHT).background, () => this.frame());
    this.watcher = new ResizeObserver(() => this.stage!.resize(canvas.clientWidth, canvas.clientHeight));
    this.watcher.observe(canvas.parentElement!);
    this.stage.resize(canvas.clientWidth, canvas.clientHeight);
    this.updated();
  }
  override updated() {
    const {asker, display} = this.app, scene = asker.result<Scene>('scene');
    if (!this.stage || !scene) return;
    const colours = display.theme === 'dark' ? DARK : LIGHT;
    if (scene !== this.drawn.scene || !this.drawn.key.startsWith(display.theme)) {
      const key = display.theme + JSON.stringify(scene);  // most sliders do not change what is drawn
      if (key !== this.drawn.key) {
        this.machine = new MachineScene(scene, colours);
        this.stage.show(this.machine, colours, this.fitted !== scene.title);
        this.fitted = scene.title;
        this.traced = this.marked = [];
      }
      this.drawn = {scene, key};
    }
    const before = this.motion;
    this.motion = this.shownMotion.of(this.app);
    this.draw();
    if (before !== this.motion) this.requestUpdate();
  }
  override disconnectedCallback() {
    super.disconnectedCallback();
    this.watcher?.disconnect();
    this.stage?.dispose();
  }

  /// The axis of the selected body in the undamped mode that is shown.
  private screw(): [PlacedScrew, SceneBody] | [null, null] {
    const {asker, display: {shown, damped}, state: {selection}} = this.app, modes = asker.result<Modes>('modes');
    const body = selection?.kind === 'body' ? this.machine?.scene.bodies.find(b => b.name === selection.name) : undefined;
    const screw = modes && body && shown.kind === 'mode' && !damped ? screwOf(modes, shown.number, body) : null;
    return screw && body ? [screw, body] : [null, null];
  }
  private markScrew() {
    const {asker, display: {shown, damped}, state: {selection}} = this.app, wanted = [asker.result('modes'), shown, damped, selection];
    if (wanted.every((value, i) => value === this.marked[i]) && this.marked.length) return;
    this.marked = wanted;
    const [screw, body] = this.screw();
    this.machine!.showScrew(screw, body);
  }
  /// Draws what changed: at once what a hand changed, and what follows moving numbers when there is time for it.
  private draw() {
    const {asker, display: {playing, phase, traces, ghost, share, damped, shown, colouring}, state} = this.app, stage = this.stage!;
    const hand = [this.machine, playing, phase, traces, ghost, share, damped, shown, colouring, state.selection, state.case];
    const numbers = [this.motion, ...colouring === 'none' ? [] : ['verdict', 'check', 'modes'].map(command => asker.result(command))];
    const differ = (now: unknown[], before: unknown[]) => now.length !== before.length || now.some((value, i) => value !== before[i]);
    const byHand = differ(hand, this.pictured.hand), isBehind = stage.isBehind || differ(numbers, this.pictured.numbers);
    this.pictured = {hand, numbers};
    if (byHand || isBehind && !this.numbersMove) stage.draw();
    else if (isBehind) stage.drawWhenFree(BESIDE_NUMBERS);
  }
  private get numbersMove() { return this.app.asker.isOld('curves') && !this.app.asker.hasErrors; }
  private mountValues() {
    const {asker, display: {colouring, shown}, state} = this.app;
    const results = {verdict: asker.result<Verdict>('verdict'), check: asker.result<Check>('check'), modes: asker.result<Modes>('modes')};
    return mountValues(colouring, results, state.case, shown.kind === 'mode' ? shown.number : null);
  }
  private poleLegend() {
    const scene = this.app.asker.result<Scene>('scene');
    return scene && markedPoles(scene).length ? html`<div class="marks"><b aria-hidden="true">P</b> pole of a body</div>` : nothing;
  }
  private legend() {
    const {asker, display: {colouring}} = this.app, command = COMMAND_OF[colouring];
    const waits = command && !asker.result(command) && (command !== 'verdict' || hasSomethingToJudge(this.app));
    return colourLegend(colouring, this.mountValues(), command !== undefined && asker.isOld(command), waits ? asker.missing(command) : '');
  }
  /// Brings the machine to the present results and phase, and asks for the next frame while it plays.
  private frame() {
    if (!this.machine) return;
    const {display, state} = this.app, now = performance.now(), step = Math.min((now - this.last) / 1000, 0.1);
    this.last = now;
    if (display.playing && this.motion) {
      display.phase = (display.phase + 2 * Math.PI * display.speed * step) % (2 * Math.PI);
      this.stage!.drawWhenFree(this.numbersMove ? BESIDE_NUMBERS : ALONE);
    }
    this.size();
    this.trace();
    this.machine.highlight(state.selection);
    this.markScrew();
    this.machine.colour(this.mountValues());
    this.machine.move(this.motion, display.phase, this.scale);
  }
  /// The scale of the drawn motion, found again only if it changed.
  private size() {
    const {share} = this.app.display, wanted = [this.machine, this.motion, share];
    if (wanted.every((value, i) => value === this.sized[i])) return;
    this.sized = wanted;
    this.scale = this.motion ? this.machine!.scaleFor(this.motion, share) : 0;
  }
  /// Traces of places and ghosts over a period, made again only if they changed.
  private trace() {
    const {traces, ghost} = this.app.display, wanted = [traces, ghost, this.motion, this.scale];
    if (wanted.every((value, i) => value === this.traced[i])) return;
    this.traced = wanted;
    this.machine!.showTraces(traces ? this.motion : null, this.scale);
    this.machine!.showGhosts(ghost, this.motion, this.scale);
  }
  private slider(name: string, min: number, max: number, step: number, value: number, set: (value: number) => void) {
    return html`<label class="small">${name}<input type="range" min=${min} max=${max} step=${step} .value=${String(value)}
                  @input=${(e: Event) => set(Number((e.target as HTMLInputElement).value))}></label>`;
  }
  private choose(event: Event) {
    const {value} = event.target as HTMLSelectElement, {display, asker} = this.app, {shown} = display;
    if (value === 'frequency') {
      if ('omega' in shown) display.set({shown: {kind: 'frequency', omega: shown.omega}});
    } else if (value.startsWith('steady')) {
      const {omega, motion} = steadyChoices(asker.result<Steady>('steady'), display)[Number(value.split(' ')[1])]!;
      display.set({shown: {kind: 'steady', omega, motion}, cursor: omega});
    } else return display.set({shown: value === 'rest' ? {kind: 'rest'} : {kind: 'mode', number: Number(value)}});
    asker.again();
  }
  private down = [0, 0];
  private pressed(event: PointerEvent) { this.down = [event.clientX, event.clientY]; }
  private released(event: PointerEvent) {
    if (Math.hypot(event.clientX - this.down[0]!, event.clientY - this.down[1]!) < 4) {
      const under = this.under(event);
      this.app.state.select(under && {kind: under.kind, name: under.name});
    }
  }
  private moved(event: PointerEvent) {
    if (event.buttons) return;
    const under = this.under(event), name = under?.words ?? under?.name ?? '';
    if (name !== this.hovered) {
      this.hovered = name;
      this.requestUpdate();
    }
  }
  private under(event: PointerEvent) {
    const {left, top, width, height} = (event.currentTarget as HTMLElement).getBoundingClientRect();
    return this.stage!.pick(2 * (event.clientX - left) / width - 1, 1 - 2 * (event.clientY - top) / height);
  }
  private savePicture() {
    const {state, display, asker} = this.app, title = asker.result<Scene>('scene')?.title ?? '', name = state.case ? `case ${state.case}` : '';
    this.stage!.drawNow();
    const drawing = this.querySelector('canvas')!, lines = [[title, name].filter(Boolean).join(' · '), this.label()].filter(Boolean);
    labelledPicture(drawing, lines, display.theme === 'dark' ? DARK : LIGHT, drawing.width / drawing.clientWidth).toBlob(blob => download('machine.png', blob!));
  }
  /// Exactly one period, as fast as the machine moves on the page.
  private async saveVideo() {
    const {display} = this.app, {phase, playing} = display, seconds = 1 / display.speed, {motion} = this;
    this.recording = true;
    display.set({playing: false});
    try {
      const bytes = await periodVideo(this.querySelector('canvas')!, seconds, share => {
        if (this.motion !== motion) throw new Error('the motion was changed meanwhile.');
        display.phase = 2 * Math.PI * share;
        this.stage!.drawNow();
      });
      download('machine.webm', new Blob([bytes as BlobPart], {type: 'video/webm'}));
      display.set({notice: `machine.webm: one period in ${framesOf(seconds).count} frames.`});
    } catch (error) {
      display.set({notice: `No video: ${error instanceof Error ? error.message : String(error)}`});
    }
    this.recording = false;
    display.set({phase, playing});
  }
}
const COMMAND_OF: Partial<Record<Colouring, string>> = {limit: 'verdict', utilisation: 'check', deflection: 'check', compression: 'check', energy: 'modes'};
customElements.define('machine-view', MachineView);
